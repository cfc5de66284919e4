// weld.cpp - which of many values are the same, by a hash table with open addressing.
#include "readers/mesh/weld.h"

#include <algorithm>
#include <bit>

namespace firsthit {
namespace {

constexpr std::uint32_t kFree = 0xFFFFFFFFu;

glm::uvec3 key_of(const glm::vec3& value)
{
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x == 0.0f ? 0.0f : x); };
    return {bits(value.x), bits(value.y), bits(value.z)};
}

glm::uvec3 key_of(const glm::uvec3& value)
{
    return value;
}

/// Multiplications by odd 64-bit constants (those of Steele, Lea and Flood 2014, "Fast Splittable
/// Pseudorandom Number Generators") carry every bit to the top, where the table's index is taken.
std::uint64_t hash(const glm::uvec3& key)
{
    std::uint64_t h = (std::uint64_t(key.x) << 32 | key.y) * 0xBF58476D1CE4E5B9u;
    h ^= h >> 29;
    h += key.z;
    h *= 0x94D049BB133111EBu;
    h ^= h >> 32;
    return h * 0x9E3779B97F4A7C15u;
}

template <class Value>
Welded weld_values(std::span<const Value> values)
{
    Welded welded;
    welded.number.resize(values.size());

    // At most half full.
    const int table_bits = std::max(4, static_cast<int>(std::bit_width(values.size() * 2)));
    std::vector<std::uint32_t> table(std::size_t(1) << table_bits, kFree);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::uvec3 key = key_of(values[i]);
        std::size_t slot = hash(key) >> (64 - table_bits);
        while (table[slot] != kFree && key_of(values[welded.first[table[slot]]]) != key)
            slot = (slot + 1) & (table.size() - 1);
        if (table[slot] == kFree) {
            table[slot] = static_cast<std::uint32_t>(welded.first.size());
            welded.first.push_back(static_cast<std::uint32_t>(i));
        }
        welded.number[i] = table[slot];
    }
    return welded;
}

} // namespace

Welded weld(std::span<const glm::vec3> values)
{
    return weld_values(values);
}
Welded weld(std::span<const glm::uvec3> values)
{
    return weld_values(values);
}

} // namespace firsthit
