// spot_cone-inl.h - a spot's cone: which directions have light, a register at a time.
#if defined(FIRSTHIT_HITS_SPOT_CONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_SPOT_CONE_INL_H_
#undef FIRSTHIT_HITS_SPOT_CONE_INL_H_
#else
#define FIRSTHIT_HITS_SPOT_CONE_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/spot_cone.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

#include "glsl/spot_cone.glsl"

/// As those of spot_cone.h.
FIRSTHIT_PURE real spot_share(const SpotCone& cone, real3 d)
{
    const real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return cone_share(versine(axis, d), cone.outer, cone.inv_width);
}
FIRSTHIT_PURE truth in_cone(const SpotCone& cone, real3 d)
{
    const real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return versine(axis, d) < real(cone.outer);
}

/// float(double(a) - origin): one coordinate of to_light (exact/shadow_ray.h) for a light that has
/// a position, with the same bits.
FIRSTHIT_PURE real from_light(real a, double origin)
{
    alignas(64) float lane[kLanes];
    store(a, lane);
    for (int k = 0; k < kLanes; ++k) lane[k] = static_cast<float>(double(lane[k]) - origin);
    return load(lane);
}
FIRSTHIT_PURE real3 from_light(real3 p, const glm::dvec3& origin)
{
    return real3(from_light(p.x, origin.x), from_light(p.y, origin.y), from_light(p.z, origin.z));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
