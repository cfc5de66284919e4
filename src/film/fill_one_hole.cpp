// fill_one_hole.cpp - fills a single hole of a picture.
#include "film/fill_one_hole.h"

#include <algorithm>

namespace firsthit {
namespace {

/// The weighted sum of the colours around a hole.
struct WeightedColor {
    float sum[3] = {};
    float weight = 0;

    void add(const float* color, float share)
    {
        for (int c = 0; c < 3; ++c) sum[c] += share * color[c];
        weight += share;
    }
};

/// Adds the pixels of one ring that are not holes. The ring is the border of the window around (x,
/// y); all pixels inside it are holes.
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

} // namespace

bool fill_one_hole(const HolePicture& picture, int x, int y, int reach)
{
    const std::size_t at = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
    if (!picture.hole[at]) return false;
    WeightedColor mean;
    for (; mean.weight == 0 && reach <= kFillReach; ++reach) add_ring(picture, x, y, reach, mean);
    if (mean.weight == 0) return false;
    for (std::size_t c = 0; c < 3; ++c) picture.color[at * 3 + c] = mean.sum[c] / mean.weight;
    return true;
}

} // namespace firsthit
