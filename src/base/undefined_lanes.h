// undefined_lanes.h - tells MemorySanitizer of reads past the end that are meant.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define FIRSTHIT_MSAN 1
#endif
#endif

namespace firsthit {

/// Memory of whole registers of which some lanes may be undefined; what comes of these is masked.
inline void may_be_undefined(
    [[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef FIRSTHIT_MSAN
    __msan_unpoison(memory, bytes);
#endif
}

} // namespace firsthit
