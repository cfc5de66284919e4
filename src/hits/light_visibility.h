// light_visibility.h - how much of each light reaches the samples of one tile.
#pragma once

#include <cstddef>

namespace firsthit {

/// (lights, samples) in tile order, 0 (in shadow) to 1; each light's part is aligned to 64 bytes.
/// Only samples with an item are defined.
struct LightVisibility {
    const float* lit = nullptr; // null: every light reaches everything
    std::size_t samples = 0;    // of the tile, from one light's part to the next

    const float* of_light(std::size_t light) const { return lit ? lit + light * samples : nullptr; }
};

} // namespace firsthit
