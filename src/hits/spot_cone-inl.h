// spot_cone-inl.h - a spot's cone: how much light goes in a direction, for a register of
// directions.
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

/// See the functions of these names in spot_cone.h.
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

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
