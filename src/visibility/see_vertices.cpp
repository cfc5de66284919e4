// see_vertices.cpp - vertices to a light's face, a register at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/see_vertices.cpp"
#include "base/simd.h"

#include "visibility/light_mesh.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::CappedTag<float, 16>;

void see_register(const LightFace& face, const float* corner, float* seen)
{
    const Reals d;
    auto px = hn::Zero(d), py = px, pz = px;
    hn::LoadInterleaved3(d, corner, px, py, pz);
    const auto limit = hn::Set(d, kFarthest);
    auto sound = hn::And(hn::Lt(hn::Abs(px), limit),
        hn::And(hn::Lt(hn::Abs(py), limit), hn::Lt(hn::Abs(pz), limit)));
    const auto along = [&](int axis) { return axis == 0 ? px : axis == 1 ? py : pz; };
    const auto a = along(face.axis_a), b = along(face.axis_b);
    const auto c = hn::Mul(along(face.axis_c), hn::Set(d, face.sign));
    auto x = a, y = b, w = hn::Neg(c);
    if (!face.directional) {
        sound = hn::And(sound, hn::Gt(c, hn::Zero(d)));
        x = hn::Div(a, c);
        y = hn::Div(b, c);
        w = hn::Div(hn::Set(d, 1.0f), c);
    }
    hn::StoreInterleaved3(hn::IfThenElse(sound, x, hn::NaN(d)), y, w, d, seen);
}

void see(const LightFace& face, const glm::vec3* corner, std::size_t count, SeenPoint* seen)
{
    const std::size_t lanes = hn::Lanes(Reals());
    std::size_t v = 0;
    for (; v + lanes <= count; v += lanes) see_register(face, &corner[v].x, &seen[v].x);
    if (v == count) return;
    float from[3 * 16] = {}, to[3 * 16];
    std::copy_n(&corner[v].x, 3 * (count - v), from);
    see_register(face, from, to);
    std::copy_n(to, 3 * (count - v), &seen[v].x);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(see);

void see_vertices(
    const LightFace& face, const glm::vec3* corner, std::size_t count, SeenPoint* seen)
{
    HWY_DYNAMIC_DISPATCH(see)(face, corner, count, seen);
}

} // namespace firsthit
#endif
