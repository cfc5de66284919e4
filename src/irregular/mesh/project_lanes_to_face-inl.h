// project_lanes_to_face-inl.h - projects one register of points to a face.
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

/// A register of ProjectedPoint. x, y and w are garbage in lanes that are not valid: their points
/// are behind the face or unusable.
template <class D>
struct ProjectedLanes {
    hn::Vec<D> x, y, w;
    hn::Mask<D> valid;
};

/// Projects points of the pencil's space. All code projects vertices by this function, so that a
/// vertex has the same projection, with the same roundings, everywhere.
template <class D>
HWY_INLINE ProjectedLanes<D> project_lanes_to_face(
    D d, const CubeFace& face, hn::Vec<D> px, hn::Vec<D> py, hn::Vec<D> pz)
{
    const auto limit = hn::Set(d, kFarthest);
    auto valid = hn::And(hn::Lt(hn::Abs(px), limit),
        hn::And(hn::Lt(hn::Abs(py), limit), hn::Lt(hn::Abs(pz), limit)));
    const auto along = [&](int axis) { return axis == 0 ? px : axis == 1 ? py : pz; };
    const auto a = along(face.axis_a), b = along(face.axis_b);
    const auto c = hn::Mul(along(face.axis_c), hn::Set(d, face.sign));
    if (face.directional) return {a, b, hn::Neg(c), valid};
    valid = hn::And(valid, hn::Gt(c, hn::Zero(d)));
    return {hn::Div(a, c), hn::Div(b, c), hn::Div(hn::Set(d, 1.0f), c), valid};
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
