// undefined_lanes.h - tells MemorySanitizer about intended reads past the end of an array.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define FIRSTHIT_MSAN 1
#endif
#endif

namespace firsthit {

/// Declares memory as initialised for MemorySanitizer. For whole registers with undefined lanes,
/// whose results are masked.
inline void may_be_undefined(
    [[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef FIRSTHIT_MSAN
    __msan_unpoison(memory, bytes);
#endif
}

} // namespace firsthit
