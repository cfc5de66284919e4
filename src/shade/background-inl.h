// background-inl.h - fills the samples that see no triangle.
#if defined(FIRSTHIT_SHADE_BACKGROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_BACKGROUND_INL_H_
#undef FIRSTHIT_SHADE_BACKGROUND_INL_H_
#else
#define FIRSTHIT_SHADE_BACKGROUND_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/hit_tile.h"
#include "shade/shade_tile.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Writes `value` to the given samples of a block.
HWY_INLINE void fill_samples(float* block, std::uint64_t samples, float value)
{
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const std::uint64_t bits = lane_bits(samples, first);
        if (bits == lane_bits(~std::uint64_t(0), 0))
            store(value, block + first);
        else if (bits != 0)
            store_where(truth_of_bits(bits), value, block + first);
    }
}

/// Calls f(block, samples) with the samples that are in no run, for each block that has such.
template <class F>
HWY_INLINE void for_empty_samples(const HitTile& hits, const F& f)
{
    constexpr int kMaxBlocks = (kMaxTile / kBlock) * (kMaxTile / kBlock);
    const int blocks = static_cast<int>(hits.blocks());
    std::uint64_t found[kMaxBlocks];
    const std::uint64_t* covered = hits.covered;
    if (!covered) {
        for (int block = 0; block < blocks; ++block) found[block] = 0;
        for (const HitRun& run : hits.runs) found[run.block] |= run.samples;
        covered = found;
    }
    for (int block = 0; block < blocks; ++block)
        if (~covered[block] != 0) f(block, ~covered[block]);
}

/// Writes the samples that are in no run: the background's colour to the colour target, 0 to the
/// others.
inline void fill_background(
    const HitTile& hits, const glm::vec3& background, const ShadeTargets& targets)
{
    for_empty_samples(hits, [&](int block, std::uint64_t samples) {
        const auto fill = [&](float* plane, float value) {
            if (plane) fill_samples(plane + block * kBlockSamples, samples, value);
        };
        for (int axis = 0; axis < 3; ++axis) {
            fill(targets.color[axis], background[axis]);
            fill(targets.normal[axis], 0.0f);
            fill(targets.geometric_normal[axis], 0.0f);
            fill(targets.position[axis], 0.0f);
            fill(targets.albedo[axis], 0.0f);
            fill(targets.emission[axis], 0.0f);
        }
        for (int axis = 0; axis < 2; ++axis) {
            fill(targets.uv[axis], 0.0f);
            fill(targets.metallic_roughness[axis], 0.0f);
        }
    });
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
