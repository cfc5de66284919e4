// environment_background-inl.h - shows the environment where samples see no triangle.
#if defined(FIRSTHIT_SHADE_ENVIRONMENT_BACKGROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_ENVIRONMENT_BACKGROUND_INL_H_
#undef FIRSTHIT_SHADE_ENVIRONMENT_BACKGROUND_INL_H_
#else
#define FIRSTHIT_SHADE_ENVIRONMENT_BACKGROUND_INL_H_
#endif

#include "hits/hit_position-inl.h"
#include "shade/background-inl.h"
#include "shade/sample_environment-inl.h"
#include "shade/shade_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace wide {

/// The light from the directions of two registers of a block's samples.
HWY_INLINE real3 light_behind(const BlockRays& rays, int first, const ShadeEnvironment& environment)
{
    if (rays.parallel) return environment_from({&environment}, both(rays.forward));
    const real3 direction = ray_direction(real(rays.x0) + load(kBlockSamplesXY.x + first),
        real(rays.y0) + load(kBlockSamplesXY.y + first), real(rays.step_x), real(rays.step_y),
        both(rays.right), both(rays.down), both(rays.forward));
    return environment_from({&environment}, direction);
}

} // namespace wide

/// Writes the colours of the samples that are in no run.
HWY_NOINLINE void fill_environment(
    const HitTile& hits, const Scene& scene, const ShadeTargets& targets)
{
    const ShadeEnvironment environment = shade_environment(scene.environment);
    for_empty_samples(hits, [&](int block, std::uint64_t samples) {
        const BlockRays rays = block_rays(hits, static_cast<std::uint32_t>(block));
        for (int first = 0; first < kBlockSamples; first += wide::kLanes) {
            const std::uint64_t bits = wide::lane_bits(samples, first);
            if (bits == 0) continue;
            const wide::real3 light = wide::light_behind(rays, first, environment);
            const auto write = [&](const wide::real& value, float* plane) {
                store_where(
                    wide::truth_of_bits(bits), value, plane + block * kBlockSamples + first);
            };
            write(light.x, targets.color[0]);
            write(light.y, targets.color[1]);
            write(light.z, targets.color[2]);
        }
    });
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
