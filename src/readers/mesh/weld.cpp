// weld.cpp - which of many values are the same, by hash tables with open addressing.
#include "readers/mesh/weld.h"
#include "base/buffer.h"
#include "base/large_pages.h"

#include <algorithm>
#include <bit>

namespace firsthit {
namespace {

constexpr std::uint32_t kFree = 0xFFFFFFFFu;

std::uint32_t bits_of(float x)
{
    return std::bit_cast<std::uint32_t>(x == 0.0f ? 0.0f : x);
}

glm::uvec3 key_of(const glm::vec3& value)
{
    return {bits_of(value.x), bits_of(value.y), bits_of(value.z)};
}

VertexKey key_of(const VertexKey& value)
{
    return value;
}

/// Multiplications by odd 64-bit constants (those of Steele, Lea and Flood 2014, "Fast Splittable
/// Pseudorandom Number Generators") carry every bit to the top, and the last shift to the bottom.
std::uint64_t hash(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t h = a * 0xBF58476D1CE4E5B9u;
    h ^= h >> 29;
    h += b;
    h *= 0x94D049BB133111EBu;
    h ^= h >> 32;
    h *= 0x9E3779B97F4A7C15u;
    return h ^ h >> 32;
}

std::uint64_t hash(const glm::uvec3& key)
{
    return hash(std::uint64_t(key.x) << 32 | key.y, key.z);
}

std::uint64_t hash(const VertexKey& key)
{
    return hash(std::uint64_t(key[0]) << 32 | key[1], std::uint64_t(key[2]) << 32 | key[3]);
}

// Values that one thread takes at once.
constexpr std::size_t kGrain = 1 << 14;

// The values are dealt out by their hashes into so many parts that the table of one stays in cache.
constexpr std::size_t kPart = 1 << 13; // values
constexpr std::size_t kMostParts = 1 << 10;

/// The parts of many values, by the top bits of their hashes.
struct Parts {
    std::size_t count = 1;
    std::vector<std::size_t> first; // (count + 1) where each part begins
    Buffer<std::uint32_t> value;    // the values of each part, ascending
    Buffer<std::uint64_t> hash;     // of those
};

template <class Value>
Parts deal_out(std::span<const Value> values, Tasks& tasks)
{
    Parts parts;
    while (parts.count < kMostParts && parts.count * kPart < values.size()) parts.count *= 2;
    // The part of a hash; one part has no bits.
    const auto part_of = [shift = std::countr_zero(parts.count)](std::uint64_t h) {
        return static_cast<std::size_t>(h >> 32) >> (32 - shift);
    };
    const std::size_t ranges = (values.size() + kGrain - 1) / kGrain;
    Buffer<std::uint64_t> hashes;
    hashes.resize(values.size());
    std::vector<std::uint32_t> place(ranges * parts.count); // of each range in each part
    tasks.for_ranges(values.size(), kGrain, [&](std::size_t first, std::size_t last) {
        std::uint32_t* const counts = &place[first / kGrain * parts.count];
        for (std::size_t i = first; i < last; ++i) {
            hashes[i] = hash(key_of(values[i]));
            ++counts[part_of(hashes[i])];
        }
    });
    parts.first.resize(parts.count + 1);
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts.count; ++part) {
        parts.first[part] = sum;
        for (std::size_t r = 0; r < ranges; ++r) {
            const std::uint32_t count = place[r * parts.count + part];
            place[r * parts.count + part] = sum;
            sum += count;
        }
    }
    parts.first[parts.count] = sum;
    parts.value.resize(values.size());
    parts.hash.resize(values.size());
    tasks.for_ranges(values.size(), kGrain, [&](std::size_t first, std::size_t last) {
        std::uint32_t* const places = &place[first / kGrain * parts.count];
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t at = places[part_of(hashes[i])]++;
            parts.value[at] = static_cast<std::uint32_t>(i);
            parts.hash[at] = hashes[i];
        }
    });
    return parts;
}

/// Writes for each value of a part the first one that equals it.
template <class Value>
void find_first(std::span<const Value> values, std::span<const std::uint32_t> part,
    std::span<const std::uint64_t> hashes, std::vector<std::uint32_t>& first)
{
    // At most half full; its index is of the lower bits, since the part took upper ones.
    const std::size_t size = std::bit_ceil(part.size() * 2 + 1);
    std::vector<std::uint32_t> table(size, kFree);
    for (std::size_t k = 0; k < part.size(); ++k) {
        const std::uint32_t i = part[k];
        const auto key = key_of(values[i]);
        std::size_t slot = hashes[k] & (size - 1);
        while (table[slot] != kFree && key_of(values[table[slot]]) != key)
            slot = (slot + 1) & (size - 1);
        if (table[slot] == kFree) table[slot] = i;
        first[i] = table[slot];
    }
}

template <class Value>
Welded weld_values(std::span<const Value> values, Tasks& tasks)
{
    std::vector<std::uint32_t> first;
    resize_in_large_pages(first, values.size());
    {
        const Parts parts = deal_out(values, tasks);
        tasks.for_each(parts.count, [&](std::size_t p, std::size_t) {
            const std::size_t begin = parts.first[p], size = parts.first[p + 1] - begin;
            find_first(values, parts.value.span().subspan(begin, size),
                parts.hash.span().subspan(begin, size), first);
        });
    }
    // Number them in order; those that come first are known before the others.
    Welded welded;
    welded.number = std::move(first);
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::uint32_t& number = welded.number[i];
        if (number == i) {
            number = static_cast<std::uint32_t>(welded.first.size());
            welded.first.push_back(static_cast<std::uint32_t>(i));
        } else {
            number = welded.number[number];
        }
    }
    return welded;
}

} // namespace

Welded weld(std::span<const glm::vec3> values, Tasks& tasks)
{
    return weld_values(values, tasks);
}

Welded weld(std::span<const VertexKey> values, Tasks& tasks)
{
    return weld_values(values, tasks);
}

VertexKey key_bits(const glm::vec4& value)
{
    return {bits_of(value.x), bits_of(value.y), bits_of(value.z), bits_of(value.w)};
}

} // namespace firsthit
