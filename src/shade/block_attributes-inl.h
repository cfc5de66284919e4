// block_attributes-inl.h - interpolates normals and texture coordinates at the samples of a block.
//
// Shading a block has two steps. The first one, here, goes run by run and computes only what
// depends on the triangle, which is a few operations. The second one, in shade_block-inl.h, does
// the rest for all samples of a material at once. Its registers are full, however few samples a run
// has.
#if defined(FIRSTHIT_SHADE_BLOCK_ATTRIBUTES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_BLOCK_ATTRIBUTES_INL_H_
#undef FIRSTHIT_SHADE_BLOCK_ATTRIBUTES_INL_H_
#else
#define FIRSTHIT_SHADE_BLOCK_ATTRIBUTES_INL_H_
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

/// The interpolated attributes of a block's samples, which the first step hands to the second,
/// where they become a Surface (material/surface.glsl). Undefined for samples that are in no run.
struct alignas(64) BlockAttributes {
    float normal[3][kBlockSamples];    // interpolated, not unit, on the eye's side; if needed
    float geometric[3][kBlockSamples]; // unit, towards the eye; if needed
    float facing[kBlockSamples][4];    // RunFacing; if needed
    float uv[2][kBlockSamples];
    float footprint2[kBlockSamples]; // see texture.glsl; only for textures of models without maps

    // For materials with maps, if needed (MapNeeds), and for scenes with colours of vertices.
    float uv1[2][kBlockSamples];        // the second texture coordinates
    float uv_step[2][4][kBlockSamples]; // of both: u's to the next sample along x and y, and v's
    float tangent[3][kBlockSamples];    // interpolated, flipped with the normal
    float side[kBlockSamples];          // of the bitangent: see mapped_normal
    float color[3][kBlockSamples];      // of the vertices
};

FIRSTHIT_PURE real interpolate(float at0, float to1, float to2, real u, real v)
{
    return real(at0) + (u * to1 + v * to2);
}

/// Calls f(first, chosen, all) for each register with samples of the set. first: the register's
/// first sample; chosen: the lanes whose samples are in the set; all: whether all lanes are.
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

/// Writes interpolated vectors of the run.
HWY_INLINE void spread_vector(const Interpolated<glm::vec3>& of_run, const HitRun& run,
    const HitTile& hits, float (&plane)[3][kBlockSamples])
{
    const std::size_t at = std::size_t(run.block) * kBlockSamples;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        const real u = load(hits.u + at + first);
        const real v = load(hits.v + at + first);
        for (int axis = 0; axis < 3; ++axis)
            store_where(chosen, all,
                interpolate(of_run.at0[axis], of_run.to1[axis], of_run.to2[axis], u, v),
                plane[axis] + first);
    });
}

HWY_INLINE void spread_geometric(
    const glm::vec3& geometric, const HitRun& run, BlockAttributes& attributes)
{
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        for (int axis = 0; axis < 3; ++axis)
            store_where(chosen, all, geometric[axis], attributes.geometric[axis] + first);
    });
}

/// The depth t that footprint2 and texture_step multiply gradients by: 1 for rays that do not spread.
FIRSTHIT_PURE real footprint_depth(const HitTile& hits, std::size_t at)
{
    return hits.rays.parallel ? real(1.0f) : load(hits.t + at);
}

/// The texture coordinates of a run's triangle, and its texture or null.
struct RunUv {
    const Interpolated<glm::vec2>& uv;
    const RunGradients& gradients; // undefined without a texture
    const Texture* texture;
};

/// Writes the run's texture coordinates and, where there is a texture, the footprints.
HWY_INLINE void spread_uv(
    const RunUv& run_uv, const HitRun& run, const HitTile& hits, BlockAttributes& attributes)
{
    const Interpolated<glm::vec2>& uv = run_uv.uv;
    const RunGradients& gradients = run_uv.gradients;
    const Texture* texture = run_uv.texture;
    const std::size_t at = std::size_t(run.block) * kBlockSamples;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        const real u = load(hits.u + at + first);
        const real v = load(hits.v + at + first);
        // Relative to corner 0: the footprint is a small difference, and texture coordinates may be
        // large.
        const real tex_u = interpolate(0.0f, uv.to1.x, uv.to2.x, u, v);
        const real tex_v = interpolate(0.0f, uv.to1.y, uv.to2.y, u, v);
        store_where(chosen, all, real(uv.at0.x) + tex_u, attributes.uv[0] + first);
        store_where(chosen, all, real(uv.at0.y) + tex_v, attributes.uv[1] + first);
        if (!texture) return;
        const real2 size(
            static_cast<float>(texture->width()), static_cast<float>(texture->height()));
        store_where(chosen, all,
            footprint2(tex_u, tex_v, footprint_depth(hits, at + std::size_t(first)),
                from_glm(gradients.u), from_glm(gradients.v), from_glm(gradients.one), size),
            attributes.footprint2 + first);
    });
}

/// Writes the run's texture coordinates of a set, and how much they change from sample to sample.
template <int set>
HWY_INLINE void spread_uv_steps(
    const RunUv& run_uv, const HitRun& run, const HitTile& hits, BlockAttributes& attributes)
{
    const Interpolated<glm::vec2>& uv = run_uv.uv;
    const RunGradients& gradients = run_uv.gradients;
    float(&plane)[2][kBlockSamples] = set == 0 ? attributes.uv : attributes.uv1;
    float(&step)[4][kBlockSamples] = attributes.uv_step[set];
    const std::size_t at = std::size_t(run.block) * kBlockSamples;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        const real u = load(hits.u + at + first);
        const real v = load(hits.v + at + first);
        const real t = footprint_depth(hits, at + std::size_t(first));
        // Relative to corner 0, as in spread_uv.
        const real tex_u = interpolate(0.0f, uv.to1.x, uv.to2.x, u, v);
        const real tex_v = interpolate(0.0f, uv.to1.y, uv.to2.y, u, v);
        store_where(chosen, all, real(uv.at0.x) + tex_u, plane[0] + first);
        store_where(chosen, all, real(uv.at0.y) + tex_v, plane[1] + first);
        const glm::vec2& one = gradients.one;
        store_where(chosen, all, texture_step(tex_u, t, gradients.u.x, one.x), step[0] + first);
        store_where(chosen, all, texture_step(tex_u, t, gradients.u.y, one.y), step[1] + first);
        store_where(chosen, all, texture_step(tex_v, t, gradients.v.x, one.x), step[2] + first);
        store_where(chosen, all, texture_step(tex_v, t, gradients.v.y, one.y), step[3] + first);
    });
}

/// A triangle with tangents, and its plane's normal towards the eye.
struct TangentTriangle {
    const ShadeArrays& arrays;
    const glm::uvec3& corner;
    const glm::vec3& to_eye;
};

/// Writes the run's tangents.
HWY_INLINE void spread_tangent(const TangentTriangle& triangle, const HitRun& run,
    const HitTile& hits, BlockAttributes& attributes)
{
    const ShadeArrays& arrays = triangle.arrays;
    const float flip =
        arrays.normal ? side_of_normals(arrays, triangle.corner, triangle.to_eye) : 1.0f;
    spread_vector(run_tangent(arrays, triangle.corner, flip), run, hits, attributes.tangent);
    const float side = flip * arrays.tangent[triangle.corner.x].w;
    for_registers(run.samples, [&](int first, truth chosen, bool all) {
        store_where(chosen, all, side, attributes.side + first);
    });
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
