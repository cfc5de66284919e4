// ground.h - a floor under what a scene shows.
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace firsthit {

/// A square, seen from both sides, that is part of the scene like any other surface.
struct Ground {
    glm::dvec3 middle{0};   // in world space
    glm::dvec3 up{0, 1, 0}; // of any length but 0
    double half_side = 1;   // world units, above 0
    glm::vec3 color{0.5f};  // what it reflects diffusely, linear Rec.709, 0 or more
};

/// Adds a ground as the last instance of a scene, with a node and a material of its own, all named "ground".
/// It has the last two triangle ids. In a scene with an environment its material is a rough MetallicRoughness, else
/// Phong.
///
/// returns  its material's number, of Scene::materials
/// throws   ArgumentError: a number that is not finite, a direction of length 0, a side that is not above 0
std::uint32_t add_ground(Scene& scene, const Ground& ground);

} // namespace firsthit
