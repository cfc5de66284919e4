// tile_hull.h - a convex hull around the hits of a tile.
#pragma once

#include "exact/shadow_ray.h"
#include "hits/hit_tile.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace firsthit {

/// Bound of a hit position's rounding error, relative to the sum of the sizes of the terms that are
/// added up to it. The float roundings themselves are at most a sixteenth of this.
inline constexpr double kPositionRounding = 0x1p-18;

/// The hits of a tile lie in the convex hull of eight points: the tile's corner rays at its least
/// and at its greatest depth. Because of rounding, each coordinate of a hit may be up to `rounding`
/// outside. World space.
struct TileHull {
    std::array<glm::dvec3, 8> corner;
    double rounding = 0;
    bool empty = true; // the tile has no hits
};

TileHull tile_hull(const HitTile& hits);

/// The largest absolute value of all coordinates; 0 without points.
float largest_coordinate(std::span<const glm::vec3> points);

/// The same where the lamp is far from all points (is_far_lamp in exact/shadow_ray.h). Infinite where it is
/// not, which is mostly found by the first of them.
float farthest_coordinate(const Light& light, std::span<const glm::vec3> points);

} // namespace firsthit
