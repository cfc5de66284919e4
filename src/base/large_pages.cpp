// large_pages.cpp - asks the system to use large pages for large arrays.
#include "base/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace firsthit {

void request_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t kLarge = std::uintptr_t(1) << 21;
    if (bytes < 2 * kLarge) return;
    // madvise() takes whole small pages; the system finds the large pages inside the range.
    constexpr std::uintptr_t kSmall = 4096;
    const std::uintptr_t first = (std::uintptr_t(memory) + kSmall - 1) / kSmall * kSmall,
                         last = (std::uintptr_t(memory) + bytes) / kSmall * kSmall;
    (void)::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

} // namespace firsthit
