// block_surface-inl.h - spreads runs over the samples of their block: normals, texture coordinates.
//
// Shading a block has two steps. This one goes run by run, and only does what depends on the
// triangle, which is a few operations. Then phong_block-inl.h does the rest for all samples of a
// material at once, in full registers, however short the runs are.
#if defined(FIRSTHIT_SHADE_BLOCK_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_BLOCK_SURFACE_INL_H_
#undef FIRSTHIT_SHADE_BLOCK_SURFACE_INL_H_
#else
#define FIRSTHIT_SHADE_BLOCK_SURFACE_INL_H_
#endif

#include "hits/hit_position-inl.h"
#include "shade/run_setup.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

#include "glsl/power.glsl"
#include "glsl/phong.glsl"
#include "glsl/texture.glsl"

FIRSTHIT_PURE real2 from_glm(const glm::vec2& v)
{
    return real2(v.x, v.y);
}

/// The samples of one block, between the two steps. Only samples of its runs are defined.
struct alignas(64) BlockSurface {
    float normal[3][kBlockSamples];    // interpolated, not unit, on the eye's side
    float geometric[3][kBlockSamples]; // unit, towards the eye
    float uv[2][kBlockSamples];
    float footprint2[kBlockSamples]; // see texture.glsl; of textured materials only
};

FIRSTHIT_PURE real interpolate(float at0, float to1, float to2, real u, real v)
{
    return real(at0) + (u * to1 + v * to2);
}

/// Writes the run's samples.
///
/// texture   of the run's material, or null
/// with_uv   also the texture coordinates of untextured materials
HWY_INLINE void spread_run(const RunSetup& setup, const HitRun& run, const HitTile& hits,
    const Texture* texture, bool with_uv, BlockSurface& surface)
{
    const float* block_t = hits.t + std::size_t(run.block) * kBlockSamples;
    const float* block_u = hits.u + std::size_t(run.block) * kBlockSamples;
    const float* block_v = hits.v + std::size_t(run.block) * kBlockSamples;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const std::uint64_t bits = lane_bits(run.samples, first);
        if (bits == 0) continue;
        const truth chosen = truth_of_bits(bits);
        const real u = load(block_u + first);
        const real v = load(block_v + first);

        for (int axis = 0; axis < 3; ++axis) {
            store_where(chosen,
                interpolate(
                    setup.normal.at0[axis], setup.normal.to1[axis], setup.normal.to2[axis], u, v),
                surface.normal[axis] + first);
            store_where(chosen, setup.geometric[axis], surface.geometric[axis] + first);
        }

        if (!texture && !with_uv) continue;
        // Less corner 0, whose value may be large: the footprint is a small difference.
        const real tex_u = interpolate(0.0f, setup.uv.to1.x, setup.uv.to2.x, u, v);
        const real tex_v = interpolate(0.0f, setup.uv.to1.y, setup.uv.to2.y, u, v);
        store_where(chosen, real(setup.uv.at0.x) + tex_u, surface.uv[0] + first);
        store_where(chosen, real(setup.uv.at0.y) + tex_v, surface.uv[1] + first);
        if (!texture) continue;
        const real2 size(static_cast<float>(texture->levels[0].width),
            static_cast<float>(texture->levels[0].height));
        store_where(chosen,
            footprint2(tex_u, tex_v, load(block_t + first), from_glm(setup.grad_u),
                from_glm(setup.grad_v), from_glm(setup.grad_1), size),
            surface.footprint2 + first);
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
