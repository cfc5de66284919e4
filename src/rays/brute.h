// brute.h - the oracle: every ray against every triangle.
#pragma once

#include "base/tasks.h"
#include "exact/hit.h"
#include "exact/pencil.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <span>

namespace firsthit {

/// Triangles in eye space (Pencil), as the oracles take them.
struct EyeTriangles {
    std::span<const glm::vec4> corner; // (V) w unused
    std::span<const glm::uvec3> index; // (T)

    Corners operator[](std::size_t triangle) const
    {
        const glm::uvec3& c = index[triangle];
        return {glm::vec3(corner[c.x]), glm::vec3(corner[c.y]), glm::vec3(corner[c.z])};
    }
};

/// The nearest triangle along d, ties to the lowest id; kNoItem where none is hit. This loop is the
/// definition that the item buffer has to equal.
std::uint32_t cast_brute(const EyeTriangles& triangles, const glm::vec3& d, Effort& effort);

/// The same for all rays of a pencil: items[(y * width) + x]. A triangle is left out of a row of
/// samples only where the whole row certainly misses it; everything else is decided sample by
/// sample, by the same functions as above.
/// progress  called now and then with the share that is done; may be empty
void cast_brute(const EyeTriangles& triangles, const Pencil& pencil, std::span<std::uint32_t> items,
    Tasks& tasks, const std::function<void(double)>& progress = {});

/// Both triangles are hit by the ray, at exactly the same depth. No for kNoItem.
bool is_tie(const EyeTriangles& triangles, std::uint32_t a, std::uint32_t b, const glm::vec3& d);

/// Of the ray of sample (y * width) + x.
glm::vec3 direction_of(const Pencil& pencil, std::size_t sample);

} // namespace firsthit
