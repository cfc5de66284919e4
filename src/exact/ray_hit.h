// ray_hit.h - exact predicates of any ray: does it hit a triangle, at which t, and which of two first?
//
// They say of a ray from anywhere what hit.h says of one from the origin. The ray's origin o and direction d
// are floats that are taken as exact, as are the corners of triangles; no difference of them is ever rounded.
//
//   edge(a, b)  = d . ((a - o) x (b - o))     sign of the displaced direction where it is zero (hit.h)
//   volume      = (v0 - o) . N                N = (v1 - v0) x (v2 - v0); no hit if zero
//   hit         iff edge(v0, v1), edge(v1, v2), edge(v2, v0) all have the sign of volume
//   t           = volume / (N . d)
//
// The definition includes t > 0: behind the origin, the edges have the opposite sign. A triangle without area
// has volume 0.
#pragma once

#include "exact/hit.h"

#include <firsthit/ray.h>

#include <glm/vec3.hpp>

#include <array>

namespace firsthit {

/// Whether the ray can hit anything: see Ray.
bool usable(const Ray& ray);

/// Sign of edge(a, b) of the displaced ray. 0 only if the origin is on the line through a and b.
int edge_sign(const Ray& ray, const glm::vec3& a, const glm::vec3& b, Effort& effort);

/// Whether the ray hits the triangle at any t > 0. t_min, t_max and skip are not looked at.
bool is_hit(const Ray& ray, const Corners& c, Effort& effort);

/// Which of two triangles, both hit by the ray, is hit first: -1 for a, 1 for b, 0 if both t are exactly equal.
int compare_depth(const Ray& ray, const Corners& a, const Corners& b, Effort& effort);

/// The sign of t of the hit minus `t`, which is not NaN.
int compare_depth(const Ray& ray, const Corners& c, float t, Effort& effort);

/// An interval that contains t of a hit: [0, inf] where double precision says nothing.
struct DepthInterval {
    double low, high;
};
DepthInterval depth_interval(const Ray& ray, const Corners& c);

/// t, u and v of a hit, each rounded once from the exact value as RayHit has them, and its normal.
RayHit rounded_hit(const Ray& ray, const Corners& c);

/// u and v alone.
std::array<float, 2> rounded_barycentrics(const Ray& ray, const Corners& c);

} // namespace firsthit
