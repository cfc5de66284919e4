// quantized_points.h - where on a grid of samples (sample_grid.h) something lies, in whole numbers.
#pragma once

#include "irregular/mesh/cube_face.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// A place along an axis is a whole number of 16 bits. Samples have places 1 to 65534.
inline constexpr std::uint16_t kQuantizedMax = 65535;

/// From coordinates and depths to places. Never falls as these grow, and is the same for samples and
/// triangles: so a triangle's box holds all samples that it may cover, whatever is rounded. 0: below
/// all samples, 65535: above.
struct GridAxes {
    struct Axis {
        float start = 0, scale = 0; // place = (v - start) scale + 1, rounded
    };
    Axis x, y, w;
    bool transposed = false; // a place's x is that of y, and the other way round
};

/// In a word of 64 bits, from the lowest on. w is 65535 for a corner of a triangle that is behind the
/// face or unusable.
struct alignas(8) QuantizedPoint {
    std::uint16_t w = 0, unused = 0, x = 0, y = 0;
};

/// Vertices in the light's space to the places where the face sees them.
void quantize_vertices(const GridAxes& axes, const CubeFace& face, const glm::vec3* corner,
    std::size_t count, QuantizedPoint* quantized);

} // namespace firsthit
