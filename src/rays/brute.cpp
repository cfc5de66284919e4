// brute.cpp - the oracle of hits: tests every ray against every triangle.
#include "rays/brute.h"

#include <firsthit/scene.h>

#include <array>
#include <atomic>
#include <cmath>
#include <vector>

namespace firsthit {
namespace {

/// Replaces `best` by the candidate if that is nearer.
void keep_nearest(const EyeTriangles& triangles, std::uint32_t candidate, const glm::vec3& d,
    std::uint32_t& best, Effort& effort)
{
    if (best == kNoItem) {
        best = candidate;
        return;
    }
    const int order = compare_depth(triangles[candidate], triangles[best], d, effort);
    if (order < 0 || (order == 0 && candidate < best)) best = candidate;
}

/// The plane of one edge in double: a x b, times the triangle's facing.
struct EdgePlane {
    double x, y, z;

    /// The sign of the edge function for the ray (dx, dy, 1); 0 where double precision is
    /// uncertain.
    int side(double dx, double dy) const
    {
        const double px = x * dx, py = y * dy;
        const double e = (px + py) + z;
        if (std::abs(e) <= 8 * kUlp * (std::abs(px) + std::abs(py) + std::abs(z))) return 0;
        return e > 0 ? 1 : -1;
    }
};

/// A triangle whose facing is not zero. Its three edge functions are positive inside.
struct FacedTriangle {
    std::uint32_t id;
    std::array<EdgePlane, 3> edge;
    std::array<double, 3> y, z; // of the corners

    /// Whether certainly no ray (dx, dy, 1) with dx in [first, last] hits the triangle: all corners
    /// are on one side of the plane y = dy z of these rays, or one edge function, which is affine
    /// in dx, is negative at both ends.
    bool misses_row(double first, double last, double dy) const
    {
        int above = 0, below = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = y[k] - dy * z[k];
            const double error = 4 * kUlp * (std::abs(y[k]) + std::abs(dy * z[k]));
            above += side > error;
            below += side < -error;
        }
        if (above == 3 || below == 3) return true;
        for (const EdgePlane& e : edge)
            if (e.side(first, dy) < 0 && e.side(last, dy) < 0) return true;
        return false;
    }
};

EdgePlane edge_plane(const glm::vec3& a, const glm::vec3& b, double facing)
{
    const auto cross = [&](int i, int j) {
        return facing * (double(a[i]) * double(b[j]) - double(a[j]) * double(b[i]));
    };
    return {cross(1, 2), cross(2, 0), cross(0, 1)};
}

std::vector<FacedTriangle> face(const EyeTriangles& triangles)
{
    Effort effort;
    std::vector<FacedTriangle> faced;
    for (std::size_t t = 0; t < triangles.index.size(); ++t) {
        const Corners c = triangles[t];
        if (!usable(c)) continue;
        const int facing = volume_sign(c, effort);
        if (facing == 0) continue;
        faced.push_back({std::uint32_t(t),
            {edge_plane(c[0], c[1], facing), edge_plane(c[1], c[2], facing),
                edge_plane(c[2], c[0], facing)},
            {c[0].y, c[1].y, c[2].y}, {c[0].z, c[1].z, c[2].z}});
    }
    return faced;
}

void cast_row(const EyeTriangles& triangles, const std::vector<FacedTriangle>& faced,
    const Pencil& pencil, int y, std::span<std::uint32_t> row)
{
    Effort effort;
    std::fill(row.begin(), row.end(), kNoItem);
    const double dy = pencil.y0 + y, first = pencil.x0, last = pencil.x0 + pencil.width - 1;
    for (const FacedTriangle& triangle : faced) {
        if (triangle.misses_row(first, last, dy)) continue;
        for (int x = 0; x < pencil.width; ++x) {
            const double dx = pencil.x0 + x;
            const int a = triangle.edge[0].side(dx, dy), b = triangle.edge[1].side(dx, dy),
                      c = triangle.edge[2].side(dx, dy);
            if (a < 0 || b < 0 || c < 0) continue;
            const glm::vec3 d = pencil.tile(0, 0).direction(x, y);
            if (!(a > 0 && b > 0 && c > 0) && !is_hit(triangles[triangle.id], d, effort)) continue;
            if (!triangles.is_there(triangle.id, d)) continue;
            keep_nearest(triangles, triangle.id, d, row[std::size_t(x)], effort);
        }
    }
}

} // namespace

std::uint32_t cast_brute(const EyeTriangles& triangles, const glm::vec3& d, Effort& effort)
{
    std::uint32_t best = kNoItem;
    for (std::size_t t = 0; t < triangles.index.size(); ++t)
        if (is_hit(triangles[t], d, effort) && triangles.is_there(t, d))
            keep_nearest(triangles, std::uint32_t(t), d, best, effort);
    return best;
}

glm::vec3 direction_of(const Pencil& pencil, std::size_t sample)
{
    const std::size_t width = std::size_t(pencil.width);
    return pencil.tile(0, 0).direction(int(sample % width), int(sample / width));
}

bool is_tie(const EyeTriangles& triangles, std::uint32_t a, std::uint32_t b, const glm::vec3& d)
{
    Effort effort;
    return a != kNoItem && b != kNoItem && is_hit(triangles[a], d, effort) &&
           is_hit(triangles[b], d, effort) &&
           compare_depth(triangles[a], triangles[b], d, effort) == 0;
}

void cast_brute(const EyeTriangles& triangles, const Pencil& pencil, std::span<std::uint32_t> items,
    Tasks& tasks, const std::function<void(double)>& progress)
{
    const std::vector<FacedTriangle> faced = face(triangles);
    std::atomic<int> done{0};
    tasks.for_each(std::size_t(pencil.height), [&](std::size_t y, std::size_t worker) {
        const std::size_t width = std::size_t(pencil.width);
        cast_row(triangles, faced, pencil, int(y), items.subspan(y * width, width));
        const int rows = ++done;
        if (progress && worker == 0) progress(double(rows) / pencil.height);
    });
}

} // namespace firsthit
