// bin_triangles.cpp - the prefix sum of the counting sort of triangles.
#include "irregular/mesh/bin_triangles.h"

namespace firsthit {

std::uint64_t start_bins(std::size_t shares, std::size_t bins, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start)
{
    start.resize(bins + 1, bins + 1024);
    std::uint64_t next = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        start[bin] = std::uint32_t(next);
        for (std::size_t share = 0; share < shares; ++share) {
            std::uint32_t& at = cursor[share * bins + bin];
            const std::uint32_t count = at;
            at = std::uint32_t(next);
            next += count;
        }
    }
    start[bins] = std::uint32_t(next);
    return next;
}

} // namespace firsthit
