// project_points_to_face.cpp - points in a light's space to the faces that see them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/mesh/project_points_to_face.cpp"
#include "base/simd.h"

#include "irregular/mesh/face_samples-inl.h"
#include "irregular/mesh/project_points_to_face.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// One register of points.
struct Points {
    real3 p;
    truth valid;
};

HWY_INLINE Points load_points(const LightChunk& chunk, std::size_t k)
{
    const real3 p(load(chunk.x.data() + k), load(chunk.y.data() + k), load(chunk.z.data() + k));
    return {p, {hn::And(is_usable(p).lanes, hn::FirstN(RealTag(), chunk.count - k))}};
}

HWY_INLINE truth without(truth all, truth some)
{
    return {hn::AndNot(some.lanes, all.lanes)};
}

/// The valid lanes whose major axis is the face's.
template <int kAxis>
HWY_INLINE truth on_major_face(const Points& points, float sign)
{
    return {hn::And(on_face<kAxis>(points.p, sign).lanes, points.valid.lanes)};
}

HWY_INLINE truth on_face(const Points& points, int face)
{
    const float sign = face % 2 ? -1.0f : 1.0f;
    return face < 2   ? on_major_face<0>(points, sign)
           : face < 4 ? on_major_face<1>(points, sign)
                      : on_major_face<2>(points, sign);
}

HWY_INLINE truth on_wide_face(const Points& points, int face)
{
    const float sign = face % 2 ? -1.0f : 1.0f;
    const truth on = face < 2   ? on_wide_face<0>(points.p, sign)
                     : face < 4 ? on_wide_face<1>(points.p, sign)
                                : on_wide_face<2>(points.p, sign);
    return {hn::And(on.lanes, points.valid.lanes)};
}

/// Appends the samples that lie on the face. A directional light has only one.
template <int kAxis, class Chosen>
HWY_INLINE void project_to_face(const CubeFace& face, const LightChunk& chunk,
    const Chosen& chosen_of, std::size_t first, std::span<IrregularSample> samples,
    SamplePatch& part)
{
    SampleWriter writer(samples.data(), first);
    for (std::size_t k = 0; k < chunk.count; k += kLanes) {
        const Points points = load_points(chunk, k);
        const truth chosen = chosen_of(points);
        if (hn::AllFalse(RealTag(), chosen.lanes)) continue;
        const auto id = hn::Load(hn::RebindToUnsigned<RealTag>(), chunk.id.data() + k);
        writer.add<kAxis>(points.p, face.sign, id, chosen);
    }
    part = {{first, writer.next() - first}, writer.bounds()};
}

/// The faces that see a point of the chunk that the wide one does not, a bit each.
unsigned faces_of(const LightChunk& chunk, int wide)
{
    const RealTag d;
    unsigned faces = 0;
    for (std::size_t k = 0; k < chunk.count; k += kLanes) {
        Points points = load_points(chunk, k);
        if (wide >= 0) points.valid = without(points.valid, on_wide_face(points, wide));
        for (int face = 0; face < kLightFaces; ++face)
            if (faces >> face & 1) points.valid = without(points.valid, on_face(points, face));
        if (hn::AllFalse(d, points.valid.lanes)) continue; // all on faces that are known, as mostly
        for (int face = 0; face < kLightFaces; ++face)
            if (!hn::AllFalse(d, on_face(points, face).lanes)) faces |= 1u << face;
    }
    return faces;
}

void see(const PencilMesh& mesh, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    parts = {};
    if (mesh.space.directional) {
        project_to_face<kParallel>(
            cube_face(true, 0), chunk, [](const Points& points) { return points.valid; }, first,
            samples, parts[0]);
        return;
    }
    const int wide = mesh.wide_face;
    const unsigned faces = faces_of(chunk, wide);
    for (int number = 0; number < kLightFaces; ++number) {
        if (number != wide && !(faces >> number & 1)) continue;
        const auto chosen = [&](const Points& points) {
            if (number == wide) return on_wide_face(points, number);
            const truth on = on_face(points, number);
            return wide >= 0 ? without(on, on_wide_face(points, wide)) : on;
        };
        SamplePatch& part = parts[std::size_t(number)];
        const CubeFace face = cube_face(false, number);
        if (face.axis_c == 0)
            project_to_face<0>(face, chunk, chosen, first, samples, part);
        else if (face.axis_c == 1)
            project_to_face<1>(face, chunk, chosen, first, samples, part);
        else
            project_to_face<2>(face, chunk, chosen, first, samples, part);
        first += part.range.count;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(see);

void project_points_to_face(const PencilMesh& mesh, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts)
{
    HWY_DYNAMIC_DISPATCH(see)(mesh, chunk, first, samples, parts);
}

} // namespace firsthit
#endif
