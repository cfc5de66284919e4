// hit.h - exact predicates: does a ray hit a triangle, and which of two triangles does it hit
// first? These functions are the definition of a hit. The rasteriser, the shadow pass and the
// oracles call them, or a filter that is proven to agree with them.
//
// A ray starts at the origin and has the direction d. A triangle is three float vertices relative
// to the ray's origin; these floats are taken as exact. All answers are those of exact real
// arithmetic on them.
//
//   edge(a, b, d) = d . (a x b)        six times the signed volume of (origin, a, b, d)
//   volume        = v0 . (v1 x v2)     no hit if zero: the origin lies in the triangle's plane
//   hit           iff edge(v0, v1), edge(v1, v2), edge(v2, v0) all have the sign of volume
//   depth         1 / t = (N . d) / volume, N = (v1 - v0) x (v2 - v0)
//
// If an edge function is exactly zero, its sign is taken for the displaced direction
// (d.x + e, d.y + e^2, d.z + e^3) with an infinitesimal e > 0. Since all edges of all triangles use
// the same displacement, a ray through a shared edge or vertex hits exactly one triangle of a fan,
// and it crosses a closed surface an even number of times. A rule that looks at one edge at a time
// would not be consistent at vertices.
//
// source  Davidovic et al. 2012, "3D Rasterization: A Bridge between Rasterization and Ray
//         Casting", Graphics Interface (edges as volumes); Olano and Greer 1997, "Triangle Scan
//         Conversion using 2D Homogeneous Coordinates" (no clipping); Edelsbrunner and Mücke 1990,
//         "Simulation of Simplicity" (displacement)
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace firsthit {

using Corners = std::array<glm::vec3, 3>;

/// Counts the exact work.
struct Effort {
    std::uint64_t exact_calls = 0; // predicates that needed expansions, as doubles were uncertain
};

/// A triangle with a vertex that has a coordinate this large, infinite or NaN is invisible.
inline constexpr float kFarthest = 1e30f;

/// The unit roundoff of double: half a unit in the last place of 1.
inline constexpr double kUlp = 0x1p-53;

inline bool usable(const glm::vec3& p)
{
    return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest;
}

inline bool usable(const Corners& c)
{
    return usable(c[0]) && usable(c[1]) && usable(c[2]);
}

/// Sign of d . (a x b) by expansions. 0 if it is exactly zero and either `displaced` is false or a
/// and b are parallel.
int exact_edge_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, bool displaced);

/// The same, but uses expansions only where double precision is uncertain.
inline int filtered_edge_sign(
    const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, bool displaced, Effort& effort)
{
    // A product of two floats is exact in double, so each component of a x b has one rounding.
    const double nx = double(a.y) * double(b.z) - double(a.z) * double(b.y);
    const double ny = double(a.z) * double(b.x) - double(a.x) * double(b.z);
    const double nz = double(a.x) * double(b.y) - double(a.y) * double(b.x);
    const double px = nx * double(d.x), py = ny * double(d.y), pz = nz * double(d.z);
    const double e = (px + py) + pz;
    // The error of each term is at most four roundings.
    if (std::abs(e) > 8 * kUlp * (std::abs(px) + std::abs(py) + std::abs(pz)))
        return e > 0 ? 1 : -1;
    ++effort.exact_calls;
    return exact_edge_sign(a, b, d, displaced);
}

/// Sign of edge(a, b, d) of the displaced ray. 0 only if a and b are parallel.
inline int edge_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& d, Effort& effort)
{
    return filtered_edge_sign(a, b, d, true, effort);
}

/// Sign of v0 . (v1 x v2): 1 if the corners are clockwise as seen from the origin (right-handed
/// frame).
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

/// Which of two triangles, both hit by the ray along d, is hit first: -1 for a, 1 for b, 0 if both
/// depths are exactly equal.
int compare_depth(const Corners& a, const Corners& b, const glm::vec3& d, Effort& effort);

/// The same in double precision: 0 where it is uncertain.
int compare_depth_fast(const Corners& a, const Corners& b, const glm::vec3& d);

/// Whether all six corners lie exactly in one plane. Then every ray that hits both triangles hits
/// them at equal depth.
bool are_coplanar(const Corners& a, const Corners& b);

/// The depth t of a hit, in units of |d|, in plain double arithmetic: a few roundings from the
/// exact value, unless digits cancel (see careful_hit.h).
double hit_depth(const Corners& c, const glm::vec3& d);

/// 1 / t of a hit, with a relative error below 2^-40 for any triangle.
double exact_inverse_depth(const Corners& c, const glm::vec3& d);

/// The weights of corners 1 and 2 at a hit (Embree's u and v), with the same precision.
std::array<double, 2> exact_barycentrics(const Corners& c, const glm::vec3& d);

/// The same, each rounded to the nearest float: ties to even, and to 0 below 2^-126. These are the
/// roundings of the exact weights, whatever instructions they are found by.
std::array<float, 2> rounded_barycentrics(const Corners& c, const glm::vec3& d);

/// The weights in the world where c is in the space of parallel rays (Pencil::parallel in exact/pencil.h):
/// there a corner counts by its z. From exact sums, by a few roundings of double and one to float, so the
/// bits are the same everywhere. 0 below 2^-126.
std::array<float, 2> rounded_parallel_barycentrics(const Corners& c, const glm::vec3& d);

/// Whether the depth t of a hit is greater than `nearest`, exactly.
bool is_beyond(const Corners& c, const glm::vec3& d, float nearest);

} // namespace firsthit
