// hit.h - does a ray hit a triangle, and which of two triangles does it hit first? The one place
// where that is decided: the rasteriser, the shadow pass and the oracles all call these functions
// or a filter that is proven to agree with them.
//
// A ray starts at the origin and has the direction d. A triangle is three float vertices relative
// to the ray's origin; these floats are taken as exact. Everything below is what real arithmetic
// says of them, whatever the rounding.
//
//   edge(a, b, d) = d . (a x b)        six times the signed volume of (origin, a, b, d)
//   volume        = v0 . (v1 x v2)     zero: the origin is in the triangle's plane: no hit
//   hit           iff edge(v0, v1), edge(v1, v2), edge(v2, v0) all have the sign of volume
//   depth         1 / t = (N . d) / volume, N = (v1 - v0) x (v2 - v0)
//
// Where an edge is exactly zero, the ray is displaced: the direction (d.x + e, d.y + e^2, d.z +
// e^3) for an infinitesimal e > 0 decides. This is one displacement for all edges of all triangles,
// so a ray through a shared edge or vertex hits exactly one triangle of a fan, and a closed surface
// is crossed an even number of times. A rule for each edge by itself is not consistent at vertices.
//
// source  Davidovic et al. 2012, "3D Rasterization: A Bridge between Rasterization and Ray
// Casting",
//         Graphics Interface (edges as volumes); Olano and Greer 1997, "Triangle Scan Conversion
//         using 2D Homogeneous Coordinates" (no clipping); Edelsbrunner and Mücke 1990, "Simulation
//         of Simplicity" (displacement)
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace firsthit {

using Corners = std::array<glm::vec3, 3>;

/// How much work the exact answers took.
struct Effort {
    std::uint64_t exact_calls = 0; // answered by expansions, after the double filter left it open
};

/// Vertices this far out, infinite or not a number make their triangle invisible.
inline constexpr float kFarthest = 1e30f;

/// Half a unit in the last place of 1.
inline constexpr double kUlp = 0x1p-53;

inline bool usable(const glm::vec3& p)
{
    return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest;
}

inline bool usable(const Corners& c)
{
    return usable(c[0]) && usable(c[1]) && usable(c[2]);
}

/// Sign of d . (a x b) by expansions; 0 where it is exactly zero and `displaced` is false or the
/// edge has no direction.
int exact_edge_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, bool displaced);

/// The same in doubles first; expansions only where they cannot tell.
inline int filtered_edge_sign(
    const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, bool displaced, Effort& effort)
{
    // A product of two floats is exact in double: one rounding for each component of a x b.
    const double nx = double(a.y) * double(b.z) - double(a.z) * double(b.y);
    const double ny = double(a.z) * double(b.x) - double(a.x) * double(b.z);
    const double nz = double(a.x) * double(b.y) - double(a.y) * double(b.x);
    const double px = nx * double(d.x), py = ny * double(d.y), pz = nz * double(d.z);
    const double e = (px + py) + pz;
    // Each term carries at most four roundings.
    if (std::abs(e) > 8 * kUlp * (std::abs(px) + std::abs(py) + std::abs(pz)))
        return e > 0 ? 1 : -1;
    ++effort.exact_calls;
    return exact_edge_sign(a, b, d, displaced);
}

/// Sign of edge(a, b, d), displaced. 0 only where a and b are parallel.
inline int edge_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, Effort& effort)
{
    return filtered_edge_sign(a, b, d, true, effort);
}

/// Sign of v0 . (v1 x v2): 1 where the origin sees the corners clockwise in a right-handed frame.
inline int volume_sign(const Corners& c, Effort& effort)
{
    return filtered_edge_sign(c[1], c[2], c[0], false, effort);
}

/// Whether the ray along d hits the triangle at any t > 0.
inline bool is_hit(const Corners& c, const glm::vec3& d, Effort& effort)
{
    if (!usable(c)) return false;
    const int facing = volume_sign(c, effort);
    return facing != 0 && edge_sign(c[0], c[1], d, effort) == facing &&
           edge_sign(c[1], c[2], d, effort) == facing && edge_sign(c[2], c[0], d, effort) == facing;
}

/// Which of two triangles, both hit by the ray along d, is hit first: -1 for a, 1 for b, 0 where
/// both depths are exactly equal.
int compare_depth(const Corners& a, const Corners& b, const glm::vec3& d, Effort& effort);

/// The same in doubles: 0 where they cannot tell.
int compare_depth_fast(const Corners& a, const Corners& b, const glm::vec3& d);

/// Whether all six corners lie in one plane, exactly. Then all depths of common hits are equal.
bool are_coplanar(const Corners& a, const Corners& b);

/// The depth t of a hit, in units of |d|: a few double roundings from the exact value.
double hit_depth(const Corners& c, const glm::vec3& d);

/// 1 / t of a hit with a relative error below 2^-40, whatever the triangle.
double exact_inverse_depth(const Corners& c, const glm::vec3& d);

/// The weights of corners 1 and 2 at a hit (Embree's u and v), as precisely.
std::array<double, 2> exact_barycentrics(const Corners& c, const glm::vec3& d);

} // namespace firsthit
