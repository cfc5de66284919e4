// fill_holes.cpp - gives pixels without a colour of their own the colours around them.
#include "film/fill_holes.h"

#include <algorithm>
#include <cstring>

namespace firsthit {
namespace {

/// What comes together from around a hole.
struct WeightedColor {
    float sum[3] = {};
    float weight = 0;

    void add(const float* color, float share)
    {
        for (int c = 0; c < 3; ++c) sum[c] += share * color[c];
        weight += share;
    }
};

/// Adds the pixels of one ring that are no holes: those at `reach` from (x, y) in x or y. All
/// windows inside have none.
void add_ring(const HolePicture& picture, int x, int y, int reach, WeightedColor& mean)
{
    const auto add = [&](int px, int py) {
        if (px < 0 || px >= picture.width) return;
        const std::size_t at = std::size_t(py) * std::size_t(picture.width) + std::size_t(px);
        if (picture.hole[at]) return;
        const int dx = px - x, dy = py - y;
        mean.add(&picture.color[at * 3], 1.0f / float(dx * dx + dy * dy));
    };
    const int top = std::max(y - reach, 0), bottom = std::min(y + reach, picture.height - 1);
    for (int py = top; py <= bottom; ++py) {
        const bool whole_row = py == y - reach || py == y + reach;
        for (int px = x - reach; px <= x + reach; px += whole_row ? 1 : 2 * reach) add(px, py);
    }
}

/// The ring of eight around a pixel that is not on the picture's edge, which fills most holes.
void add_nearest(const HolePicture& picture, std::size_t at, WeightedColor& mean)
{
    const std::size_t row = std::size_t(picture.width);
    const auto add = [&](std::size_t pixel, float share) {
        if (!picture.hole[pixel]) mean.add(&picture.color[pixel * 3], share);
    };
    add(at - row - 1, 0.5f), add(at - row, 1), add(at - row + 1, 0.5f);
    add(at - 1, 1), add(at + 1, 1);
    add(at + row - 1, 0.5f), add(at + row, 1), add(at + row + 1, 0.5f);
}

bool fill(const HolePicture& picture, int x, int y)
{
    const std::size_t at = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
    WeightedColor mean;
    int reach = 1;
    if (x > 0 && y > 0 && x + 1 < picture.width && y + 1 < picture.height) {
        add_nearest(picture, at, mean);
        ++reach;
    }
    for (; mean.weight == 0 && reach <= kFillReach; ++reach) add_ring(picture, x, y, reach, mean);
    if (mean.weight == 0) return false;
    for (std::size_t c = 0; c < 3; ++c) picture.color[at * 3 + c] = mean.sum[c] / mean.weight;
    return true;
}

} // namespace

std::uint64_t fill_holes(const HolePicture& picture, int first, int last)
{
    std::uint64_t filled = 0;
    for (int y = first; y < last; ++y) {
        const std::uint8_t* row = picture.hole.data() + std::size_t(y) * std::size_t(picture.width);
        const std::uint8_t* end = row + picture.width;
        for (const std::uint8_t* hole = row; hole < end; ++hole) {
            hole = static_cast<const std::uint8_t*>(std::memchr(hole, 1, std::size_t(end - hole)));
            if (!hole) break;
            filled += fill(picture, int(hole - row), y);
        }
    }
    return filled;
}

} // namespace firsthit
