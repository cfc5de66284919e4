// models-inl.h - the formulas of all shading models, compiled for two registers of samples.
#if defined(FIRSTHIT_MATERIAL_MODELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_MATERIAL_MODELS_INL_H_
#undef FIRSTHIT_MATERIAL_MODELS_INL_H_
#else
#define FIRSTHIT_MATERIAL_MODELS_INL_H_
#endif

#include "base/wide_real-inl.h"
#include "material/models.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace wide {

using glm::vec3;

FIRSTHIT_PURE real3 all_lanes(const vec3& v)
{
    return real3(v.x, v.y, v.z);
}

#include "glsl/power.glsl"

#include "material/texts.inl"

} // namespace wide
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
