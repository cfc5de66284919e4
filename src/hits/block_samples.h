// block_samples.h - the column and row of each sample in its block, as floats that kernels load.
#pragma once

#include "base/tile_order.h"

namespace firsthit {

/// Offsets of a block's samples from the block's origin.
struct BlockSamplesXY {
    alignas(64) float x[kBlockSamples] = {};
    alignas(64) float y[kBlockSamples] = {};
};

/// The offsets of a square block, in the order of base/tile_order.h.
inline constexpr BlockSamplesXY kBlockSamplesXY = [] {
    BlockSamplesXY samples;
    for (int k = 0; k < kBlockSamples; ++k) {
        samples.x[k] = static_cast<float>(block_x(k));
        samples.y[k] = static_cast<float>(block_y(k));
    }
    return samples;
}();

} // namespace firsthit
