// brute.h - the oracle of hits: tests every ray against every triangle.
#pragma once

#include "base/tasks.h"
#include "exact/cutouts.h"
#include "exact/hit.h"
#include "exact/pencil.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <span>

namespace firsthit {

/// Triangles in eye space (see Pencil), the input of the oracles.
struct EyeTriangles {
    std::span<const glm::vec4> corner; // (V) w unused
    std::span<const glm::uvec3> index; // (T)
    const Cutouts* cutouts = nullptr;  // of these triangles; null: all are opaque

    /// Whether the ray along d, which hits the triangle, hits something that is there.
    bool is_there(std::size_t triangle, const glm::vec3& d) const
    {
        return !cutouts || cutouts->is_there(std::uint32_t(triangle), (*this)[triangle], d);
    }

    Corners operator[](std::size_t triangle) const
    {
        const glm::uvec3& c = index[triangle];
        return {glm::vec3(corner[c.x]), glm::vec3(corner[c.y]), glm::vec3(corner[c.z])};
    }
};

/// The nearest triangle along d; of equally near ones the one with the lowest id; kNoItem if none
/// is hit. This loop is the definition that the item buffer has to equal.
std::uint32_t cast_brute(const EyeTriangles& triangles, const glm::vec3& d, Effort& effort);

/// The same for all rays of a pencil: fills in items[y * width + x]. Skips a triangle for a row of
/// samples only if the whole row certainly misses it; everything else is decided sample by sample,
/// by the same functions as above.
/// progress  called now and then with the fraction that is done, in [0, 1]; may be empty
void cast_brute(const EyeTriangles& triangles, const Pencil& pencil, std::span<std::uint32_t> items,
    Tasks& tasks, const std::function<void(double)>& progress = {});

/// Whether the ray along d hits both triangles at exactly the same depth. False if either is
/// kNoItem.
bool is_tie(const EyeTriangles& triangles, std::uint32_t a, std::uint32_t b, const glm::vec3& d);

/// The direction of the ray of sample number y * width + x.
glm::vec3 direction_of(const Pencil& pencil, std::size_t sample);

} // namespace firsthit
