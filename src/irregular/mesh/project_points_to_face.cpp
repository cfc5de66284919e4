// project_points_to_face.cpp - sorts points of a pencil's space by face and projects them to
// samples.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/mesh/project_points_to_face.cpp"
#include "base/simd.h"

#include "base/undefined_lanes.h"
#include "irregular/mesh/face_samples-inl.h"
#include "irregular/mesh/project_points_to_face.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// One register of points; lanes that are past the end or unusable are not valid.
struct Points {
    real3 p;
    truth valid;
};

HWY_INLINE Points load_points(const PointChunk& chunk, std::size_t k)
{
    constexpr std::size_t kBytes = std::size_t(kLanes) * sizeof(float); // past the last point too
    for (const auto* values : {&chunk.x, &chunk.y, &chunk.z})
        may_be_undefined(values->data() + k, kBytes);
    may_be_undefined(chunk.id.data() + k, kBytes);
    const real3 p(load(chunk.x.data() + k), load(chunk.y.data() + k), load(chunk.z.data() + k));
    return {p, {hn::And(is_usable(p).lanes, hn::FirstN(RealTag(), chunk.count - k))}};
}

HWY_INLINE truth without(truth all, truth some)
{
    return {hn::AndNot(some.lanes, all.lanes)};
}

/// The valid lanes whose points lie on the face (see on_face in face_samples-inl.h).
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

/// Writes the points for which chosen_of(points) is true as samples of the face, from index `first`
/// on. Returns their range and bounds.
template <int kAxis, class Chosen>
HWY_INLINE SamplePatch project_to_face(const CubeFace& face, const PointChunk& chunk,
    const Chosen& chosen_of, std::size_t first, std::span<IrregularSample> samples)
{
    SampleWriter writer(samples.data(), first);
    for (std::size_t k = 0; k < chunk.count; k += kLanes) {
        const Points points = load_points(chunk, k);
        const truth chosen = chosen_of(points);
        if (hn::AllFalse(RealTag(), chosen.lanes)) continue;
        const auto id = hn::Load(hn::RebindToUnsigned<RealTag>(), chunk.id.data() + k);
        writer.add<kAxis>(points.p, face.sign, id, chosen);
    }
    return {{first, writer.next() - first}, writer.bounds()};
}

/// The faces on which a point of the chunk lies that is not on the wide face (wide < 0: there is
/// none). Bit k stands for face k.
unsigned faces_of(const PointChunk& chunk, int wide)
{
    const RealTag d;
    unsigned faces = 0;
    for (std::size_t k = 0; k < chunk.count; k += kLanes) {
        Points points = load_points(chunk, k);
        if (wide >= 0) points.valid = without(points.valid, on_wide_face(points, wide));
        for (int face = 0; face < kCubeFaces; ++face)
            if (faces >> face & 1) points.valid = without(points.valid, on_face(points, face));
        if (hn::AllFalse(d, points.valid.lanes)) continue; // the most frequent case
        for (int face = 0; face < kCubeFaces; ++face)
            if (!hn::AllFalse(d, on_face(points, face).lanes)) faces |= 1u << face;
    }
    return faces;
}

void project_points(const PencilMesh& mesh, const PointChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FacePatches& patches)
{
    patches = {};
    if (mesh.space.directional) {
        patches[0] = project_to_face<kParallel>(
            cube_face(true, 0), chunk, [](const Points& points) { return points.valid; }, first,
            samples);
        return;
    }
    const int wide = mesh.wide_face;
    const unsigned faces = faces_of(chunk, wide);
    for (int number = 0; number < kCubeFaces; ++number) {
        if (number != wide && !(faces >> number & 1)) continue;
        const auto chosen = [&](const Points& points) {
            if (number == wide) return on_wide_face(points, number);
            const truth on = on_face(points, number);
            return wide >= 0 ? without(on, on_wide_face(points, wide)) : on;
        };
        SamplePatch& patch = patches[std::size_t(number)];
        const CubeFace face = cube_face(false, number);
        if (face.axis_c == 0)
            patch = project_to_face<0>(face, chunk, chosen, first, samples);
        else if (face.axis_c == 1)
            patch = project_to_face<1>(face, chunk, chosen, first, samples);
        else
            patch = project_to_face<2>(face, chunk, chosen, first, samples);
        first += patch.range.count;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(project_points);

void project_points_to_face(const PencilMesh& mesh, const PointChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FacePatches& patches)
{
    HWY_DYNAMIC_DISPATCH(project_points)(mesh, chunk, first, samples, patches);
}

} // namespace firsthit
#endif
