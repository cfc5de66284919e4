// ray.h - any ray, and what it hits.
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>

namespace firsthit {

/// A ray: the points origin + t direction with t > 0 and t_min <= t <= t_max. The direction may have any
/// length, denormal or huge. A ray hits nothing if its direction is zero, infinite or NaN in a coordinate, or if
/// a coordinate of its origin is NaN or not between -1e30 and 1e30. If t_max is less than t_min, or one of them is
/// NaN, it hits nothing either.
struct Ray {
    glm::vec3 origin{0};    // world space, metres
    glm::vec3 direction{0}; // world space; t counts its lengths
    float t_min = 0; // least t; 0 or less: all from the origin on, the origin itself excluded
    float t_max = std::numeric_limits<float>::infinity(); // greatest t
    std::uint32_t skip = kNoItem; // a triangle that the ray does not hit; kNoItem: none
};

/// What a ray hits. t, u and v are the exact values, each rounded once to the nearest float. A t below 2^-126 is 0,
/// one beyond the largest float is infinite.
struct RayHit {
    float t = std::numeric_limits<float>::infinity(); // in lengths of the direction; +inf: no hit
    std::uint32_t triangle = kNoItem;                 // its id; kNoItem where nothing is hit
    float u = 0;                                      // weight of the triangle's corner 1, 0 to 1
    float v = 0;                                      // weight of corner 2
    glm::vec3 normal{0}; // unit; the corners are counter-clockwise around it. 0: no hit
};

} // namespace firsthit
