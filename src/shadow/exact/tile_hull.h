// tile_hull.h - where the hits of a tile are, seen from outside of it.
#pragma once

#include "hits/hit_tile.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace firsthit {

/// Of all that is added up to a hit's position: float's roundings on the way are a sixteenth of that.
inline constexpr double kPositionRounding = 0x1p-18;

/// The hits of a tile lie in the hull of eight points: the corner rays at the least and the greatest
/// depth. Each coordinate of a hit is at most `rounding` away. World space.
struct TileHull {
    std::array<glm::dvec3, 8> corner;
    double rounding = 0;
    bool empty = true; // no hits
};

TileHull tile_hull(const HitTile& hits);

/// The largest size of a coordinate.
float largest_coordinate(std::span<const glm::vec3> points);

} // namespace firsthit
