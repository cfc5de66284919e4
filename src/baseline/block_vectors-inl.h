// block_vectors-inl.h - a vector for each sample of a block, in memory, from which packets of rays
// are loaded.
#if defined(FIRSTHIT_BASELINE_BLOCK_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_BASELINE_BLOCK_VECTORS_INL_H_
#undef FIRSTHIT_BASELINE_BLOCK_VECTORS_INL_H_
#else
#define FIRSTHIT_BASELINE_BLOCK_VECTORS_INL_H_
#endif

#include "hits/hit_position-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Structure of arrays, in the order of base/tile_order.h.
struct BlockVectors {
    alignas(64) float x[kBlockSamples];
    alignas(64) float y[kBlockSamples];
    alignas(64) float z[kBlockSamples];

    /// Sets the vectors of the samples [first, first + kLanes).
    HWY_INLINE void set(int first, real3 v)
    {
        store(v.x, x + first);
        store(v.y, y + first);
        store(v.z, z + first);
    }
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
