// fresh_memory.h - fills newly allocated memory, so that tests find code that reads it before
// writing.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// The values that newly allocated memory of buffers is filled with.
enum class FreshFill : std::uint8_t {
    none,   // it is not filled
    zeros,  // 0x00000000
    ones,   // 0xFFFFFFFF: a negative NaN, kNoItem
    nan,    // 0x7FC00000: the NaN that arithmetic makes
    one,    // 0x3F800000: 1.0f, a plausible number
    minus,  // 0xBF800000: -1.0f
    random, // different bits in each buffer
};

/// The fill of all buffers that the process allocates from now on. For tests only: pictures must
/// not depend on it.
inline std::atomic<FreshFill> fresh_fill{FreshFill::none};

/// Fills memory as `fill` says.
void fill_memory(void* memory, std::size_t bytes, FreshFill fill);

/// Fills newly allocated memory if a test has set `fresh_fill`.
inline void fill_fresh(void* memory, std::size_t bytes)
{
    const FreshFill fill = fresh_fill.load(std::memory_order_relaxed);
    if (fill != FreshFill::none) [[unlikely]]
        fill_memory(memory, bytes, fill);
}

} // namespace firsthit
