// light_visibility.h - how much of each light, and of the sky, reaches the samples of one tile.
#pragma once

#include "hits/sky_visibility.h"

#include <cstddef>

namespace firsthit {

/// The share of each light that reaches each sample of a tile, from 0 (in shadow) to 1.
struct LightVisibility {
    /// (lights, samples) in tile order; each light's part is aligned to 64 bytes. Undefined for
    /// samples without an item. Null if all light reaches all samples.
    const float* lit = nullptr;
    std::size_t samples = 0; // samples of the tile
    SkyVisibility sky{};     // of the same samples

    /// (samples) of one light, or null.
    const float* of_light(std::size_t light) const { return lit ? lit + light * samples : nullptr; }
};

} // namespace firsthit
