// fresh_memory.cpp - fills newly allocated memory, so that tests find code that reads it before
// writing.
#include "base/fresh_memory.h"

#include <cstring>

namespace firsthit {
namespace {

std::uint32_t pattern_of(FreshFill fill)
{
    switch (fill) {
    case FreshFill::ones:
        return 0xFFFFFFFF;
    case FreshFill::nan:
        return 0x7FC00000;
    case FreshFill::one:
        return 0x3F800000;
    case FreshFill::minus:
        return 0xBF800000;
    default:
        return 0;
    }
}

} // namespace

void fill_memory(void* memory, std::size_t bytes, FreshFill fill)
{
    static std::atomic<std::uint64_t> seed{1};
    std::uint64_t state = seed.fetch_add(0x9E3779B97F4A7C15, std::memory_order_relaxed);
    const auto next = [&] {
        if (fill != FreshFill::random) return pattern_of(fill);
        state = state * 6364136223846793005 + 1442695040888963407; // Knuth's MMIX
        return std::uint32_t(state >> 32);
    };
    auto* const to = static_cast<unsigned char*>(memory);
    std::size_t at = 0;
    for (; at + 4 <= bytes; at += 4) {
        const std::uint32_t word = next();
        std::memcpy(to + at, &word, 4);
    }
    const std::uint32_t word = next();
    std::memcpy(to + at, &word, bytes - at);
}

} // namespace firsthit
