// see_points.cpp - points in a light's space to the faces that see them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/see_points.cpp"
#include "base/simd.h"

#include "visibility/item_tile.h"
#include "visibility/see_points.h"

#include <hwy/highway.h>

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

/// Appends the samples of one face. A directional light has only one.
void see_face(const LightSpace& space, const LightChunk& chunk, int number, std::size_t& next,
    std::span<IrregularSample> samples, SampleBounds& bounds)
{
    const Reals d;
    const Numbers du;
    const bool directional = space.directional;
    const LightFace face = light_face(directional, number);
    const Real infinite = hn::Inf(d), least = hn::Neg(infinite);
    const Real one = hn::Set(d, 1.0f), greatest = hn::Set(d, kGreatestW);
    Real x0 = infinite, y0 = infinite, x1 = least, y1 = least, far = infinite, near = least;
    for (std::size_t k = 0; k < chunk.count; k += hn::Lanes(d)) {
        const Points p = load_points(chunk, k);
        const auto chosen = directional ? p.valid : on_face(p, number);
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

/// The faces that see a point of the chunk, a bit each.
unsigned faces_of(const LightChunk& chunk)
{
    const Reals d;
    unsigned faces = 0;
    for (std::size_t k = 0; k < chunk.count; k += hn::Lanes(d)) {
        const Points p = load_points(chunk, k);
        for (int face = 0; face < kLightFaces; ++face)
            if (!(faces >> face & 1) && !hn::AllFalse(d, on_face(p, face))) faces |= 1u << face;
    }
    return faces;
}

void see(const LightSpace& space, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    const unsigned faces = space.directional ? 1 : faces_of(chunk);
    std::size_t next = first;
    for (int face = 0; face < kLightFaces; ++face) {
        const std::size_t start = next;
        SamplePatch& part = parts[std::size_t(face)];
        part = {};
        if (faces >> face & 1) see_face(space, chunk, face, next, samples, part.bounds);
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

void see_points(const LightSpace& space, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    HWY_DYNAMIC_DISPATCH(see)(space, chunk, first, samples, parts);
}

} // namespace firsthit
#endif
