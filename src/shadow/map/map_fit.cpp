// map_fit.cpp - chooses the size and frustum of a shadow map.
#include "shadow/map/map_fit.h"

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Rounds to the nearest of 1, 1.25, 1.5, 1.75 times a power of two.
int round_size(double size)
{
    const double quarter = std::exp2(std::floor(std::log2(size)) - 2);
    return int(std::round(size / quarter) * quarter);
}

struct Side {
    double low, high;
    double length() const { return high - low; }
};

Side round_outwards(double low, double high, double step)
{
    return {std::floor(low / step) * step, std::ceil(high / step) * step};
}

} // namespace

MapFit map_fit(const FaceBounds& bounds, int size, int filter)
{
    if (bounds.hits == 0) return {};
    // Room for the filter. If the size is not known yet, assumes the smallest.
    const double wide = double(bounds.x1) - double(bounds.x0),
                 high = double(bounds.y1) - double(bounds.y0);
    const double border = std::max(wide, high) * (0.5 * filter + 1) /
                          std::max(size ? size : kSmallestMap, 2 * filter);
    // Hits that share one position still need texels whose coordinates float can tell apart.
    const double farthest = std::max({std::abs(double(bounds.x0)), std::abs(double(bounds.y0)),
        std::abs(double(bounds.x1)), std::abs(double(bounds.y1))});
    const double extent = std::max({wide, high, farthest * 0x1p-12, 0x1p-100}) + 2 * border;
    const double step = std::exp2(std::floor(std::log2(extent)) - 3);
    const Side x = round_outwards(double(bounds.x0) - border, double(bounds.x1) + border, step);
    const Side y = round_outwards(double(bounds.y0) - border, double(bounds.y1) + border, step);
    // A flat rectangle of hits has at least one step.
    const double across = std::max(x.length(), step), down = std::max(y.length(), step);
    const double longer = std::max(across, down), shorter = std::min(across, down);

    MapFit fit;
    if (size == 0)
        size = std::clamp(round_size(std::sqrt(double(bounds.hits) * longer / shorter)),
            kSmallestMap, kLargestMap);
    fit.texel = longer / size;
    fit.width = std::clamp(int(std::ceil(across / fit.texel)), 1, size);
    fit.height = std::clamp(int(std::ceil(down / fit.texel)), 1, size);
    fit.middle_x = 0.5 * (x.low + x.high);
    fit.middle_y = 0.5 * (y.low + y.high);
    return fit;
}

} // namespace firsthit
