// sky_light-inl.h - the light of the sky that reaches two registers of samples.
#if defined(FIRSTHIT_SHADE_SKY_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SKY_LIGHT_INL_H_
#undef FIRSTHIT_SHADE_SKY_LIGHT_INL_H_
#else
#define FIRSTHIT_SHADE_SKY_LIGHT_INL_H_
#endif

#include "hits/sky_visibility.h"
#include "material/models-inl.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace wide {

/// What samples receive of a sky.
struct SkyLight {
    real3 light;   // from the sky and the ground, as a white surface shows it
    real openness; // the share of the sky before them that is open, which dims environments
};

/// The samples of two registers in a block.
struct BlockLanes {
    std::size_t block;
    int first; // sample of the block
};

/// n  unit
HWY_INLINE SkyLight sky_light_of(const SkyVisibility& sky, const BlockLanes& lanes, const real3& n)
{
    const SkyRays& rays = *sky.rays;
    const std::uint64_t* const words = sky.of_block(lanes.block);
    const real zero(0.0f);
    real open = zero, seen = zero;
    for (std::size_t k = 0; k < rays.count(); ++k) {
        const real cosine =
            max((n.x * real(rays.x[k]) + n.y * real(rays.y[k])) + n.z * real(rays.z[k]), zero);
        open = open + cosine;
        seen = seen + mix(zero, cosine, truth_of_bits(lane_bits(words[k], lanes.first)));
    }
    seen = seen + real(rays.bounce) * (open - seen);
    const real rest(0.02f * rays.full);
    SkyLight result;
    result.openness = (seen + rest) / (open + rest);
    const real n_up = dot(n, all_lanes(rays.up));
    const real from_ground = (real(0.5f) - real(0.5f) * n_up) * result.openness;
    result.light =
        all_lanes(rays.color) * (seen / real(rays.full)) + all_lanes(rays.ground) * from_ground;
    return result;
}

} // namespace wide
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
