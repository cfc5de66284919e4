// hit_position-inl.h - computes the points in world space that a register of samples sees.
#if defined(FIRSTHIT_HITS_HIT_POSITION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_HIT_POSITION_INL_H_
#undef FIRSTHIT_HITS_HIT_POSITION_INL_H_
#else
#define FIRSTHIT_HITS_HIT_POSITION_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/block_samples.h"
#include "hits/hit_tile.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

#include "glsl/hit_position.glsl"

FIRSTHIT_PURE real3 from_glm(const glm::vec3& v)
{
    return real3(v.x, v.y, v.z);
}

/// The rays of one block of a tile (exact/rays.h). Each number is in all lanes.
struct BlockRays {
    real x0, y0; // of the block's origin, see Rays
    real step_x, step_y;
    real3 eye, right, down, forward;
    bool parallel;
};

FIRSTHIT_PURE BlockRays block_rays(const HitTile& hits, std::uint32_t block)
{
    const std::uint32_t blocks_x = static_cast<std::uint32_t>(hits.size / kBlock);
    const Rays& tile = hits.rays;
    BlockRays rays;
    // The sums are exact: see LatticeTile (exact/pencil.h).
    rays.x0 = tile.x0 + static_cast<float>(block % blocks_x * kBlock);
    rays.y0 = tile.y0 + static_cast<float>(block / blocks_x * kBlock);
    rays.step_x = tile.step_x;
    rays.step_y = tile.step_y;
    rays.eye = from_glm(tile.eye);
    rays.right = from_glm(tile.right);
    rays.down = from_glm(tile.down);
    rays.forward = from_glm(tile.forward);
    rays.parallel = tile.parallel != 0;
    return rays;
}

/// The directions of the samples [first, first + kLanes) of the block, in world space. Not unit
/// vectors; not of parallel rays, whose direction is `forward`.
FIRSTHIT_PURE real3 ray_direction(const BlockRays& rays, int first)
{
    return ray_direction(rays.x0 + load(kBlockSamplesXY.x + first),
        rays.y0 + load(kBlockSamplesXY.y + first), rays.step_x, rays.step_y, rays.right, rays.down,
        rays.forward);
}

/// The points that the samples [first, first + kLanes) of the block see at depths t, in world space.
FIRSTHIT_PURE real3 hit_positions(const BlockRays& rays, int first, real t)
{
    const real x = rays.x0 + load(kBlockSamplesXY.x + first);
    const real y = rays.y0 + load(kBlockSamplesXY.y + first);
    const real3 offset = ray_offset(x, y, rays.step_x, rays.step_y, rays.right, rays.down);
    return rays.parallel ? hit_position(rays.eye + offset, rays.forward, t)
                         : hit_position(rays.eye, offset + rays.forward, t);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
