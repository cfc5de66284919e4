// block_surface-inl.h - spreads runs over the samples of their block: normals, texture coordinates.
//
// Shading a block has two steps. This one goes run by run, and only does what depends on the
// triangle, which is a few operations. Then shade_block-inl.h does the rest for all samples of a
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
#include "glsl/texture.glsl"

FIRSTHIT_PURE real2 from_glm(const glm::vec2& v)
{
    return real2(v.x, v.y);
}

/// What a block's Surfaces (material/surface.glsl) need of its triangles, between the two steps. Only
/// samples of its runs are defined.
struct alignas(64) BlockSurface {
    float normal[3][kBlockSamples];    // interpolated, not unit, on the eye's side; where asked for
    float geometric[3][kBlockSamples]; // unit, towards the eye; where asked for
    float uv[2][kBlockSamples];
    float footprint2[kBlockSamples]; // see texture.glsl; of textured materials only
};

FIRSTHIT_PURE real interpolate(float at0, float to1, float to2, real u, real v)
{
    return real(at0) + (u * to1 + v * to2);
}

/// Calls f(first, chosen, all) for each register that has samples of the set: its first sample,
/// which of its lanes are, and whether all are.
template <class F>
HWY_INLINE void for_registers(std::uint64_t samples, const F& f)
{
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const std::uint64_t bits = lane_bits(samples, first);
        if (bits != 0) f(first, truth_of_bits(bits), bits == lane_bits(~std::uint64_t(0), 0));
    }
}

FIRSTHIT_PURE void store_where(truth chosen, bool all, real a, float* p)
{
    if (all)
        store(a, p);
    else
        store_where(chosen, a, p);
}

/// Writes the run's normals.
HWY_INLINE void spread_normal(const Interpolated<glm::vec3>& normal, const HitRun& run,
    const HitTile& hits, BlockSurface& surface)
{
    const std::size_t at = std::size_t(run.block) * kBlockSamples;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        const real u = load(hits.u + at + first);
        const real v = load(hits.v + at + first);
        for (int axis = 0; axis < 3; ++axis)
            store_where(chosen, all,
                interpolate(normal.at0[axis], normal.to1[axis], normal.to2[axis], u, v),
                surface.normal[axis] + first);
    });
}

HWY_INLINE void spread_geometric(
    const glm::vec3& geometric, const HitRun& run, BlockSurface& surface)
{
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        for (int axis = 0; axis < 3; ++axis)
            store_where(chosen, all, geometric[axis], surface.geometric[axis] + first);
    });
}

/// Writes the run's texture coordinates and, where there is a texture, the footprints.
HWY_INLINE void spread_uv(const Interpolated<glm::vec2>& uv, const RunGradients& gradients,
    const Texture* texture, const HitRun& run, const HitTile& hits, BlockSurface& surface)
{
    const std::size_t at = std::size_t(run.block) * kBlockSamples;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        const real u = load(hits.u + at + first);
        const real v = load(hits.v + at + first);
        // Less corner 0, whose value may be large: the footprint is a small difference.
        const real tex_u = interpolate(0.0f, uv.to1.x, uv.to2.x, u, v);
        const real tex_v = interpolate(0.0f, uv.to1.y, uv.to2.y, u, v);
        store_where(chosen, all, real(uv.at0.x) + tex_u, surface.uv[0] + first);
        store_where(chosen, all, real(uv.at0.y) + tex_v, surface.uv[1] + first);
        if (!texture) return;
        const real2 size(
            static_cast<float>(texture->width()), static_cast<float>(texture->height()));
        store_where(chosen, all,
            footprint2(tex_u, tex_v, load(hits.t + at + first), from_glm(gradients.u),
                from_glm(gradients.v), from_glm(gradients.one), size),
            surface.footprint2 + first);
    });
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
