// ray_transform-inl.h - computes a register of hits directly in a light's space from their depths.
#if defined(FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#undef FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#else
#define FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/block_samples.h"
#include "exact/rays.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The points at depth t of the rays (x, y), which are counted from the view axis.
/// to  the tile's rays, transformed to the space of the result
FIRSTHIT_PURE real3 transform_points(const Rays& to, real x, real y, real t)
{
    const auto axis = [&](int k) {
        const real offset = x * real(to.right[k]) + y * real(to.down[k]);
        return to.parallel ? (real(to.eye[k]) + offset) + t * real(to.forward[k])
                           : real(to.eye[k]) + t * (offset + real(to.forward[k]));
    };
    return real3(axis(0), axis(1), axis(2));
}

/// The same for the rays of samples [first, first + kLanes) of the block at (x, y) of the tile.
FIRSTHIT_PURE real3 transform_hits(const Rays& to, float x, float y, int first, real t)
{
    return transform_points(to, real(to.x0 + x) + load(kBlockSamplesXY.x + first),
        real(to.y0 + y) + load(kBlockSamplesXY.y + first), t);
}

FIRSTHIT_PURE truth operator&(truth a, truth b)
{
    return {hn::And(a.lanes, b.lanes)};
}
FIRSTHIT_PURE truth operator|(truth a, truth b)
{
    return {hn::Or(a.lanes, b.lanes)};
}
FIRSTHIT_PURE truth operator!(truth a)
{
    return {hn::Not(a.lanes)};
}
FIRSTHIT_PURE bool any(truth a)
{
    return !hn::AllFalse(RealTag(), a.lanes);
}
FIRSTHIT_PURE bool all(truth a)
{
    return hn::AllTrue(RealTag(), a.lanes);
}
FIRSTHIT_PURE real abs(real a)
{
    return real(hn::Abs(a.lanes));
}

/// Which of a light's six faces points lie on. Every point lies on exactly one.
struct OnFaces {
    truth axis[3];
    truth negative[3];

    HWY_INLINE truth of(int face) const
    {
        const int a = face / 2;
        return axis[a] & (face % 2 == 1 ? negative[a] : !negative[a]);
    }
};

FIRSTHIT_PURE OnFaces on_faces(real3 p)
{
    const real x = abs(p.x), y = abs(p.y), z = abs(p.z);
    OnFaces on;
    on.axis[2] = (z >= x) & (z >= y);
    on.axis[1] = (y >= x) & !on.axis[2];
    on.axis[0] = !(on.axis[1] | on.axis[2]);
    const real zero(0.0f);
    on.negative[0] = p.x < zero;
    on.negative[1] = p.y < zero;
    on.negative[2] = p.z < zero;
    return on;
}

/// Whether points have a shadow ray: they are not too far away and not at the light. False for NaN.
FIRSTHIT_PURE truth has_shadow_ray(real3 p, bool parallel)
{
    const real far(1e30f), zero(0.0f);
    const truth near = (abs(p.x) < far) & (abs(p.y) < far) & (abs(p.z) < far);
    if (parallel) return near;
    return near & ((abs(p.x) > zero) | (abs(p.y) > zero) | (abs(p.z) > zero));
}

/// Whether points, in a spot's frame, are inside its cone.
FIRSTHIT_PURE truth in_cone(real3 p, float tan2_cone)
{
    const real u = p.x / p.z, v = p.y / p.z;
    return (p.z > real(0.0f)) & (real(tan2_cone) >= u * u + v * v);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
