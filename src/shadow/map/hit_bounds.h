// hit_bounds.h - bounds of the visible hits on the faces of a light.
#pragma once

#include "hits/hit_tile.h"
#include "shadow/map/light_frame.h"

#include <array>
#include <cstdint>
#include <limits>

namespace firsthit {

/// The bounding rectangle of the hits on one face, or a little more, in x / z and y / z of the
/// face's axes; in x and y if the light is parallel. Empty if hits = 0.
struct FaceBounds {
    static constexpr float kInfinity = std::numeric_limits<float>::infinity();

    float x0 = kInfinity, y0 = kInfinity, x1 = -kInfinity, y1 = -kInfinity;
    std::uint64_t hits = 0;

    void add(const FaceBounds& other);
};

using LightBounds = std::array<FaceBounds, kFaces>;

/// Adds a tile's hits. Hits outside a spot light's cone and hits without a shadow ray
/// (exact/shadow_ray.h) are ignored. The result does not depend on the order of tiles.
void add_hits(const HitTile& hits, const LightFrame& light, LightBounds& bounds);

} // namespace firsthit
