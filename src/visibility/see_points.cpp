// see_points.cpp - points in a light's space to the faces that see them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/see_points.cpp"
#include "base/simd.h"

#include "visibility/item_tile.h"
#include "visibility/see_points.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::CappedTag<float, 16>;
using Numbers = hn::RebindToUnsigned<Reals>;
using Real = hn::Vec<Reals>;

/// One register of points.
struct Points {
    Real x, y, z;
    hn::Mask<Reals> valid;
};

HWY_INLINE Points load_points(const LightChunk& chunk, std::size_t k)
{
    const Reals d;
    const Real x = hn::Load(d, chunk.x.data() + k), y = hn::Load(d, chunk.y.data() + k),
               z = hn::Load(d, chunk.z.data() + k);
    const Real limit = hn::Set(d, kFarthest);
    const auto usable = hn::And(
        hn::Lt(hn::Abs(x), limit), hn::And(hn::Lt(hn::Abs(y), limit), hn::Lt(hn::Abs(z), limit)));
    return {x, y, z, hn::And(usable, hn::FirstN(d, chunk.count - k))};
}

/// The lanes that the wide face sees.
HWY_INLINE hn::Mask<Reals> on_wide_face(const Points& p, const LightFace& face)
{
    const Reals d;
    const auto along = [&](int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
    const Real widest =
        hn::Mul(along(face.axis_c), hn::Set(d, face.sign * kWidestFace)); // below 0: behind
    return hn::And(hn::And(p.valid, hn::Gt(widest, hn::Zero(d))),
        hn::And(hn::Le(hn::Abs(along(face.axis_a)), widest),
            hn::Le(hn::Abs(along(face.axis_b)), widest)));
}

/// The lanes whose major axis is the face's. Every point but 0 has one face.
HWY_INLINE hn::Mask<Reals> on_face(const Points& p, int face)
{
    const Reals d;
    const Real x = hn::Abs(p.x), y = hn::Abs(p.y), z = hn::Abs(p.z);
    const auto x_major = hn::And(hn::Ge(x, y), hn::Ge(x, z));
    const auto y_major = hn::AndNot(x_major, hn::Ge(y, z));
    const auto major = face < 2 ? x_major : face < 4 ? y_major : hn::Not(hn::Or(x_major, y_major));
    const Real along = face < 2 ? p.x : face < 4 ? p.y : p.z;
    const auto ahead = face % 2 ? hn::Lt(along, hn::Zero(d)) : hn::Gt(along, hn::Zero(d));
    return hn::And(p.valid, hn::And(major, ahead));
}

/// Appends the samples that lie on the face. A directional light has only one.
template <class Chosen>
HWY_INLINE void see_face(const LightFace& face, const LightChunk& chunk, const Chosen& chosen_of,
    std::size_t& next, std::span<IrregularSample> samples, SampleBounds& bounds)
{
    const Reals d;
    const Numbers du;
    const bool directional = face.directional;
    const Real infinite = hn::Inf(d), least = hn::Neg(infinite);
    const Real one = hn::Set(d, 1.0f), greatest = hn::Set(d, kGreatestW);
    Real x0 = infinite, y0 = infinite, x1 = least, y1 = least, far = infinite, near = least;
    for (std::size_t k = 0; k < chunk.count; k += hn::Lanes(d)) {
        const Points p = load_points(chunk, k);
        const auto chosen = chosen_of(p);
        if (hn::AllFalse(d, chosen)) continue;
        const auto along = [&](int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
        const Real a = along(face.axis_a), b = along(face.axis_b);
        const Real c = hn::Mul(along(face.axis_c), hn::Set(d, face.sign));
        Real x = a, y = b, w = hn::Neg(c);
        if (!directional) {
            x = hn::Div(a, c);
            y = hn::Div(b, c);
            w = hn::Div(one, c);
            w = hn::IfThenElse(hn::Lt(w, greatest), w, hn::NaN(d));
        }
        const auto number_w = hn::IfThenElse(hn::Eq(w, w), w, least);
        x0 = hn::IfThenElse(chosen, hn::Min(x0, x), x0);
        x1 = hn::IfThenElse(chosen, hn::Max(x1, x), x1);
        y0 = hn::IfThenElse(chosen, hn::Min(y0, y), y0);
        y1 = hn::IfThenElse(chosen, hn::Max(y1, y), y1);
        far = hn::IfThenElse(chosen, hn::Min(far, number_w), far);
        near = hn::IfThenElse(chosen, hn::Max(near, number_w), near);
        const auto id = hn::Load(du, chunk.id.data() + k);
        const auto pack = [&](Real v) { return hn::Compress(v, chosen); };
        hn::StoreInterleaved4(
            pack(x), pack(y), pack(w), pack(hn::BitCast(d, id)), d, &samples[next].x);
        next += hn::CountTrue(d, chosen);
    }
    const auto lowest = [&](Real v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto highest = [&](Real v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    bounds = {lowest(x0), lowest(y0), highest(x1), highest(y1), lowest(far), highest(near)};
}

/// The faces that see a point of the chunk that the wide one does not, a bit each.
unsigned faces_of(const LightChunk& chunk, const LightFace* wide)
{
    const Reals d;
    unsigned faces = 0;
    for (std::size_t k = 0; k < chunk.count; k += hn::Lanes(d)) {
        Points p = load_points(chunk, k);
        if (wide) p.valid = hn::AndNot(on_wide_face(p, *wide), p.valid);
        for (int face = 0; face < kLightFaces; ++face)
            if (faces >> face & 1) p.valid = hn::AndNot(on_face(p, face), p.valid);
        if (hn::AllFalse(d, p.valid)) continue; // all on faces that are known, as mostly
        for (int face = 0; face < kLightFaces; ++face)
            if (!hn::AllFalse(d, on_face(p, face))) faces |= 1u << face;
    }
    return faces;
}

void see(const LightMesh& mesh, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    const bool directional = mesh.space.directional;
    const LightFace wide = light_face(directional, std::max(mesh.wide_face, 0));
    const LightFace* const has_wide = mesh.wide_face < 0 ? nullptr : &wide;
    const unsigned faces = directional ? 0 : faces_of(chunk, has_wide);
    std::size_t next = first;
    for (int number = 0; number < kLightFaces; ++number) {
        const std::size_t start = next;
        SamplePatch& part = parts[std::size_t(number)];
        part = {};
        const auto see_chosen = [&](const auto& chosen) {
            see_face(light_face(directional, number), chunk, chosen, next, samples, part.bounds);
        };
        if (directional) {
            if (number == 0) see_chosen([](const Points& p) { return p.valid; });
        } else if (number == mesh.wide_face) {
            see_chosen([&](const Points& p) { return on_wide_face(p, wide); });
        } else if (faces >> number & 1) {
            see_chosen([&](const Points& p) {
                const auto on = on_face(p, number);
                return has_wide ? hn::AndNot(on_wide_face(p, wide), on) : on;
            });
        }
        part.range = {start, next - start};
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(see);

void see_points(const LightMesh& mesh, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    HWY_DYNAMIC_DISPATCH(see)(mesh, chunk, first, samples, parts);
}

} // namespace firsthit
#endif
