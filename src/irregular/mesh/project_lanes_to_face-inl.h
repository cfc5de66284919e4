// project_lanes_to_face-inl.h - points as a light's face sees them, a register at a time.
#if defined(FIRSTHIT_IRREGULAR_MESH_PROJECT_LANES_TO_FACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_MESH_PROJECT_LANES_TO_FACE_INL_H_
#undef FIRSTHIT_IRREGULAR_MESH_PROJECT_LANES_TO_FACE_INL_H_
#else
#define FIRSTHIT_IRREGULAR_MESH_PROJECT_LANES_TO_FACE_INL_H_
#endif

#include <hwy/highway.h>

#include "exact/hit.h"
#include "irregular/mesh/cube_face.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A register of ProjectedPoint; what is not sound is behind the face or unusable.
template <class D>
struct ProjectedLanes {
    hn::Vec<D> x, y, w;
    hn::Mask<D> sound;
};

/// Of points in the light's space. The one place where a face's roundings are made.
template <class D>
HWY_INLINE ProjectedLanes<D> project_lanes_to_face(
    D d, const CubeFace& face, hn::Vec<D> px, hn::Vec<D> py, hn::Vec<D> pz)
{
    const auto limit = hn::Set(d, kFarthest);
    auto sound = hn::And(hn::Lt(hn::Abs(px), limit),
        hn::And(hn::Lt(hn::Abs(py), limit), hn::Lt(hn::Abs(pz), limit)));
    const auto along = [&](int axis) { return axis == 0 ? px : axis == 1 ? py : pz; };
    const auto a = along(face.axis_a), b = along(face.axis_b);
    const auto c = hn::Mul(along(face.axis_c), hn::Set(d, face.sign));
    if (face.directional) return {a, b, hn::Neg(c), sound};
    sound = hn::And(sound, hn::Gt(c, hn::Zero(d)));
    return {hn::Div(a, c), hn::Div(b, c), hn::Div(hn::Set(d, 1.0f), c), sound};
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
