// ray_transform-inl.h - a register of hits straight from their depths to a light's space.
//
// A light's matrix is put together with the camera's in double, as texture projections are, so that
// only small numbers are left for float: where the eye is, as the light sees it, and the ray's way.
#if defined(FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#undef FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#else
#define FIRSTHIT_SHADOW_MAP_RAY_TRANSFORM_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/block_samples.h"
#include "hits/hit_tile.h"

#include <glm/mat3x3.hpp>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// eye + t * (right * x + down * y + forward) in some space; the ray (x, y) is counted from the view
/// axis, so that a sample's bits do not depend on the tile that it is in.
struct RayTransform {
    glm::vec3 eye, right, down, forward;
    float x0, y0; // of the tile's first sample
};

/// Into the space matrix * (p - origin) + offset.
inline RayTransform ray_transform(const TileFrame& frame, const glm::dmat3& matrix,
    const glm::dvec3& origin, const glm::dvec3& offset)
{
    const glm::dmat3 axes = matrix * glm::dmat3(frame.world_from_eye);
    const double inv_f = double(frame.inv_f);
    RayTransform to;
    to.eye = glm::vec3(matrix * (glm::dvec3(frame.eye) - origin) + offset);
    to.right = glm::vec3(axes[0] * inv_f);
    to.down = glm::vec3(axes[1] * inv_f);
    to.forward = glm::vec3(axes[2]);
    to.x0 = frame.x0;
    to.y0 = frame.y0;
    return to;
}

/// Where rays (x, y) are at depth t.
FIRSTHIT_PURE real3 transform_points(const RayTransform& to, real x, real y, real t)
{
    const auto axis = [&](int k) {
        return real(to.eye[k]) +
               t * ((x * real(to.right[k]) + y * real(to.down[k])) + real(to.forward[k]));
    };
    return real3(axis(0), axis(1), axis(2));
}

/// The same for the rays of samples [first, first + kLanes) of the block at (x, y) of the tile.
FIRSTHIT_PURE real3 transform_hits(const RayTransform& to, float x, float y, int first, real t)
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

/// Whether points have a shadow ray: not too far out, and not where the light is. No number: false.
FIRSTHIT_PURE truth has_shadow_ray(real3 p, bool parallel)
{
    const real far(1e30f), zero(0.0f);
    const truth near = (abs(p.x) < far) & (abs(p.y) < far) & (abs(p.z) < far);
    if (parallel) return near;
    return near & ((abs(p.x) > zero) | (abs(p.y) > zero) | (abs(p.z) > zero));
}

/// Whether points of a spot's frame are inside its cone.
FIRSTHIT_PURE truth in_cone(real3 p, float tan2_cone)
{
    const real u = p.x / p.z, v = p.y / p.z;
    return (p.z > real(0.0f)) & (real(tan2_cone) >= u * u + v * v);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
