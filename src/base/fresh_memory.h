// fresh_memory.h - what fresh memory holds, for tests that look for reads of it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// What memory that a buffer has just got is filled with.
enum class FreshFill : std::uint8_t {
    none,   // nothing: it is not touched
    zeros,  // 0x00000000
    ones,   // 0xFFFFFFFF: a negative NaN, kNoItem
    nan,    // 0x7FC00000: a NaN as arithmetic makes it
    one,    // 0x3F800000: 1.0f, a number that looks right
    minus,  // 0xBF800000: -1.0f
    random, // every buffer other bits
};

/// Of all buffers of the process, from now on. For tests only: pictures must not depend on it.
inline std::atomic<FreshFill> fresh_fill{FreshFill::none};

/// Fills memory as `fill` says.
void fill_memory(void* memory, std::size_t bytes, FreshFill fill);

/// Fills fresh memory where a test asked for it.
inline void fill_fresh(void* memory, std::size_t bytes)
{
    const FreshFill fill = fresh_fill.load(std::memory_order_relaxed);
    if (fill != FreshFill::none) [[unlikely]]
        fill_memory(memory, bytes, fill);
}

} // namespace firsthit
