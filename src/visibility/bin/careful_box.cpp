// careful_box.cpp - the samples of a triangle that reaches behind the eye.
//
// Only what has z > 0 is seen. Its corners in front project as usual. Where an edge goes from a
// corner a in front to a corner b behind (z <= 0), its projection runs from a's to infinity:
// x/z along a + s (b - a) has the derivative's sign of b.x a.z - a.x b.z, which does not change. So
// the box reaches to the picture's edge on that side, and on no other. Both products are exact in
// double, hence so is the comparison.
#include "visibility/bin/careful_box.h"

#include <algorithm>
#include <cmath>

namespace firsthit {

Interval project_front(const Corners& corners, int axis)
{
    Interval seen;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3& a = corners[i];
        if (!(a.z > 0)) continue;
        const double s = double(a[axis]) / double(a.z);
        seen.low = std::min(seen.low, s);
        seen.high = std::max(seen.high, s);
        for (std::size_t j = 0; j < 3; ++j) {
            const glm::vec3& b = corners[j];
            if (b.z > 0) continue;
            const double ahead = double(b[axis]) * double(a.z),
                         back = double(a[axis]) * double(b.z);
            if (ahead > back) seen.high = std::numeric_limits<double>::infinity();
            if (ahead < back) seen.low = -std::numeric_limits<double>::infinity();
        }
    }
    return seen;
}

namespace {

/// First and last of `count` samples inside the interval, whose directions start at `origin`.
/// False where there is none.
bool samples_inside(
    const Interval& seen, double origin, int count, std::int16_t& first, std::int16_t& last)
{
    constexpr double kMargin = 0x1p-12; // as in project.cpp
    const double low = std::ceil(seen.low - origin - kMargin);
    const double high = std::floor(seen.high - origin + kMargin);
    if (!(low <= high) || low > count - 1 || high < 0) return false;
    first = std::int16_t(std::max(low, 0.0));
    last = std::int16_t(std::min(high, double(count - 1)));
    return true;
}

} // namespace

std::optional<InView> careful_box(
    std::uint32_t triangle, const Corners& corners, const Pencil& pencil)
{
    if (!usable(corners)) return std::nullopt;
    InView box{triangle, 0, 0, 0, 0, std::min({corners[0].z, corners[1].z, corners[2].z})};
    if (!samples_inside(project_front(corners, 0), pencil.x0, pencil.width, box.x0, box.x1) ||
        !samples_inside(project_front(corners, 1), pencil.y0, pencil.height, box.y0, box.y1))
        return std::nullopt;
    return box;
}

} // namespace firsthit
