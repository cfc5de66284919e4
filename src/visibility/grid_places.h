// grid_places.h - where on a grid of samples (sample_grid.h) something lies, in whole numbers.
#pragma once

#include "visibility/light_face.h"

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// A place along an axis is a whole number of 16 bits: 6 for the coarse cell, the next ones for the
/// cell in it, and three more for the part of the cell. Samples have places 1 to 65534.
inline constexpr int kCoarseBits = 6, kFineBits = 10, kMostLevels = 7;
inline constexpr std::uint32_t kCoarseCells = 1u << kCoarseBits; // along an axis
inline constexpr std::uint32_t kFineMask = (1u << kFineBits) - 1;
inline constexpr std::uint16_t kLastPlace = 65535;

/// From coordinates and depths to places. Never falls as these grow, and is the same for samples and
/// triangles: so a triangle meets all cells whose samples it may cover, whatever is rounded. 0: below
/// all samples, 65535: above.
struct GridAxes {
    struct Axis {
        float start = 0, scale = 0;
    };
    Axis x, y, w;
};

/// A corner of a triangle; w is 65535 where the corner is behind the face or unusable.
struct alignas(8) GridPlace {
    std::uint16_t x, y, w, nothing;
};

/// Vertices as a face sees them, to places.
void place_vertices(
    const GridAxes& axes, const SeenPoint* seen, std::size_t count, GridPlace* places);

} // namespace firsthit
