// hit_bounds.h - the part of a light's projection that visible hits fill.
#pragma once

#include "hits/hit_tile.h"
#include "shadow/map/light_frame.h"

#include <array>
#include <cstdint>
#include <limits>

namespace firsthit {

/// The rectangle of a face that hits fill, or a little more: x / z and y / z of the face's axes, or
/// x and y where the light is parallel. Empty where hits = 0.
struct FaceBounds {
    static constexpr float kInfinity = std::numeric_limits<float>::infinity();

    float x0 = kInfinity, y0 = kInfinity, x1 = -kInfinity, y1 = -kInfinity;
    std::uint64_t hits = 0;

    void add(const FaceBounds& other);
};

using LightBounds = std::array<FaceBounds, kFaces>;

/// Adds a tile's hits. Hits outside of a spot's cone, and those without a shadow ray
/// (exact/shadow_ray.h), do not count. The result does not depend on the order of tiles.
void add_hits(const HitTile& hits, const LightFrame& light, LightBounds& bounds);

} // namespace firsthit
