// careful_box.cpp - the box of samples of a triangle that reaches behind the eye.
//
// Rays only hit what has z > 0. Corners in front of the eye project as usual. An edge from a corner
// a in front to a corner b behind (z <= 0) projects to a half line from a's projection to infinity:
// the derivative of x/z along a + s (b - a) has the sign of b.x a.z - a.x b.z, which does not
// depend on s. So the box reaches to the picture's border on that side only. Both products are
// exact in double, hence the comparison is exact too.
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

/// Finds the first and the last of `count` samples that lie inside the interval. Sample 0 is at
/// `origin`. Returns false if there is no such sample.
bool samples_inside(
    const Interval& seen, double origin, int count, std::int16_t& first, std::int16_t& last)
{
    constexpr double kMargin = 0x1p-12; // the margin of project.cpp
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
