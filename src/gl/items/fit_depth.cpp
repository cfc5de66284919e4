// fit_depth.cpp - finds the range of depths that a pencil sees.
#include "gl/items/fit_depth.h"

#include "exact/hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace firsthit::gl {
namespace {

constexpr std::size_t kTrianglesPerTask = 8192;

/// A triangle clipped by planes through the eye. Each clip adds at most one corner.
struct Polygon {
    std::array<glm::dvec3, 8> corner;
    int count = 0;

    /// Keeps the side with dot(plane, p) >= 0.
    void cut(const glm::dvec3& plane)
    {
        Polygon kept;
        for (int k = 0; k < count; ++k) {
            const glm::dvec3 &a = corner[std::size_t(k)],
                             &b = corner[std::size_t(k + 1 == count ? 0 : k + 1)];
            const double at_a = glm::dot(plane, a), at_b = glm::dot(plane, b);
            if (at_a >= 0) kept.corner[std::size_t(kept.count++)] = a;
            if ((at_a >= 0) != (at_b >= 0))
                kept.corner[std::size_t(kept.count++)] = a + (b - a) * (at_a / (at_a - at_b));
        }
        *this = kept;
    }
};

/// The planes of the pencil's four sides, half a sample outside, and the plane z = 0 of the eye.
std::array<glm::dvec3, 5> sides(const Pencil& pencil)
{
    const double left = pencil.x0 - 0.5, right = left + pencil.width;
    const double top = pencil.y0 - 0.5, bottom = top + pencil.height;
    return {glm::dvec3(1, 0, -left), {-1, 0, right}, {0, 1, -top}, {0, -1, bottom}, {0, 0, 1}};
}

struct Range {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0;

    void add(double z)
    {
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
};

} // namespace

DepthRange fit_depth(std::span<const glm::vec4> corner, std::span<const glm::uvec3> index,
    const Pencil& pencil, Tasks& tasks)
{
    const auto planes = sides(pencil);
    Range all;
    std::mutex mutex;
    tasks.for_ranges(index.size(), kTrianglesPerTask, [&](std::size_t first, std::size_t last) {
        Range range;
        for (std::size_t t = first; t < last; ++t) {
            Polygon polygon;
            // Rays hit no triangle with a corner beyond kFarthest (exact/hit.h).
            bool visible = true;
            for (int k = 0; k < 3; ++k) {
                const glm::vec4& p = corner[index[t][k]];
                visible &= std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest &&
                           std::abs(p.z) < kFarthest;
                polygon.corner[std::size_t(polygon.count++)] = glm::dvec3(p);
            }
            if (!visible) continue;
            for (const glm::dvec3& plane : planes) {
                int outside = 0;
                for (int k = 0; k < polygon.count; ++k)
                    outside += glm::dot(plane, polygon.corner[std::size_t(k)]) < 0;
                if (outside == polygon.count) polygon.count = 0;
                if (outside > 0 && polygon.count > 0) polygon.cut(plane);
            }
            for (int k = 0; k < polygon.count; ++k) range.add(polygon.corner[std::size_t(k)].z);
        }
        const std::lock_guard lock(mutex);
        all.nearest = std::min(all.nearest, range.nearest);
        all.farthest = std::max(all.farthest, range.farthest);
    });
    if (!(all.farthest > 0)) return {};
    // A margin, because triangles exactly on the far plane would be lost.
    DepthRange fit;
    fit.far = all.farthest * 1.001;
    fit.near = std::max(all.nearest * 0.999, fit.far / kMostDepths);
    return fit;
}

} // namespace firsthit::gl
