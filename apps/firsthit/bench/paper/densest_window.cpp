// densest_window.cpp - where in a picture most of something is.
#include "bench/paper/densest_window.h"

#include <algorithm>
#include <vector>

namespace firsthit::cli::bench {

/// Crow 1984, "Summed-Area Tables for Texture Mapping".
Region densest_window(std::span<const std::uint8_t> marks, int width, int side)
{
    const int height = static_cast<int>(marks.size()) / width;
    side = std::min({side, width, height});
    const auto stride = static_cast<std::size_t>(width) + 1;
    std::vector<std::uint32_t> sum(stride * (static_cast<std::size_t>(height) + 1));
    const auto at = [&](int x, int y) -> std::uint32_t& {
        return sum[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            at(x + 1, y + 1) = marks[static_cast<std::size_t>(y * width + x)] + at(x, y + 1) +
                               at(x + 1, y) - at(x, y);
    Region best{.x = 0, .y = 0, .width = side, .height = side};
    std::uint32_t most = 0;
    for (int y = 0; y + side <= height; ++y)
        for (int x = 0; x + side <= width; ++x) {
            const std::uint32_t count =
                at(x + side, y + side) - at(x, y + side) - at(x + side, y) + at(x, y);
            if (count <= most) continue;
            most = count;
            best.x = x;
            best.y = y;
        }
    return best;
}

} // namespace firsthit::cli::bench
