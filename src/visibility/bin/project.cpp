// project.cpp - transforms vertices into eye space, each of them once.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/bin/project.cpp"
#include "base/simd.h"

#include "exact/hit.h"
#include "visibility/bin/project.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::ScalableTag<double>;
using Narrow = hn::Rebind<float, Wide>;
using Whole = hn::Rebind<std::int32_t, Wide>;

/// Boxes of triangles are wider than the projection of their corners by this margin, in samples. It
/// is 2^18 times the error of a projection in double, in a picture of 16384 samples.
constexpr double kMargin = 0x1p-12;

/// The coordinate of VertexSamples for a projection s among `count` samples: the number of the
/// first sample at or after s, plus one more than the number of the last sample at or before s,
/// both clamped to [0, count].
template <class V>
V place_among(V s, int count)
{
    const Wide d;
    const V margin = hn::Set(d, kMargin), one = hn::Set(d, 1.0), all = hn::Set(d, count);
    const V first = hn::Ceil(hn::Sub(s, margin)), last = hn::Floor(hn::Add(s, margin));
    const V after = hn::Min(hn::Max(first, hn::Zero(d)), all);
    return hn::Add(after, hn::Min(hn::Max(hn::Add(last, one), hn::Zero(d)), all));
}

/// Flat corners with a greater |x/z| or |y/z|, or a smaller z, might leave the range of floats;
/// they are stored in eye space with kBehind.
constexpr float kFlattest = 0x1p40f, kNearestFlat = 0x1p-60f;

/// Transforms one register of vertices.
template <CornerSpace kSpace>
void project(const float* HWY_RESTRICT xyz, const Pencil& pencil, float* HWY_RESTRICT corner)
{
    const Wide d;
    const Narrow f;
    const Whole w;
    auto xf = hn::Zero(f), yf = xf, zf = xf;
    hn::LoadInterleaved3(f, xyz, xf, yf, zf);
    const auto px = hn::Sub(hn::PromoteTo(d, xf), hn::Set(d, pencil.eye.x));
    const auto py = hn::Sub(hn::PromoteTo(d, yf), hn::Set(d, pencil.eye.y));
    const auto pz = hn::Sub(hn::PromoteTo(d, zf), hn::Set(d, pencil.eye.z));
    const auto along = [&](int r) {
        const glm::dmat3& m = pencil.eye_from_world;
        const auto xy = hn::Add(hn::Mul(hn::Set(d, m[0][r]), px), hn::Mul(hn::Set(d, m[1][r]), py));
        return hn::Add(xy, hn::Mul(hn::Set(d, m[2][r]), pz));
    };
    auto eye_x = along(0), eye_y = along(1), eye_z = along(2);
    if (pencil.parallel) {
        eye_z = hn::Div(hn::Set(d, pencil.scale), hn::Sub(hn::Set(d, pencil.far), eye_z));
        eye_x = hn::Mul(eye_x, eye_z);
        eye_y = hn::Mul(eye_y, eye_z);
    }
    const auto x = hn::DemoteTo(f, eye_x), y = hn::DemoteTo(f, eye_y), z = hn::DemoteTo(f, eye_z);

    // Find VertexSamples. A vertex with a NaN or infinite coordinate gets kBehind.
    const auto limit = hn::Set(f, kFarthest);
    const auto finite = hn::And(
        hn::Lt(hn::Abs(x), limit), hn::And(hn::Lt(hn::Abs(y), limit), hn::Lt(hn::Abs(z), limit)));
    auto in_front = hn::And(finite, hn::Gt(z, hn::Set(f, pencil.nearest)));
    if constexpr (kSpace == CornerSpace::flat) {
        const auto widest = hn::Mul(z, hn::Set(f, kFlattest));
        in_front = hn::And(hn::And(in_front, hn::Ge(z, hn::Set(f, kNearestFlat))),
            hn::And(hn::Lt(hn::Abs(x), widest), hn::Lt(hn::Abs(y), widest)));
    }
    const auto zd = hn::PromoteTo(d, hn::IfThenElse(in_front, z, hn::Set(f, 1.0f)));
    const auto xd = hn::PromoteTo(d, hn::IfThenElseZero(in_front, x));
    const auto yd = hn::PromoteTo(d, hn::IfThenElseZero(in_front, y));
    const auto flat_x = hn::Div(xd, zd), flat_y = hn::Div(yd, zd);
    const auto column = place_among(hn::Sub(flat_x, hn::Set(d, pencil.x0)), pencil.width);
    const auto row = place_among(hn::Sub(flat_y, hn::Set(d, pencil.y0)), pencil.height);
    const auto places = hn::Or(hn::DemoteTo(w, column), hn::ShiftLeft<16>(hn::DemoteTo(w, row)));
    const auto samples = hn::IfThenElse(
        hn::RebindMask(w, in_front), places, hn::Set(w, VertexSamples::kBehind & 0xFFFF));
    const auto last = hn::BitCast(f, samples);
    if constexpr (kSpace == CornerSpace::eye) {
        hn::StoreInterleaved4(x, y, z, last, f, corner);
    } else {
        const auto or_eye = [&](auto flat, auto eye) {
            return hn::IfThenElse(in_front, flat, eye);
        };
        const auto inverse = hn::Div(hn::Set(f, 1.0f), hn::DemoteTo(f, zd));
        hn::StoreInterleaved4(or_eye(hn::DemoteTo(f, flat_x), x),
            or_eye(hn::DemoteTo(f, flat_y), y), or_eye(inverse, z), last, f, corner);
    }
}

/// The vertices are those of the mesh from number `first` on.
template <CornerSpace kSpace>
void project_all(
    std::span<const glm::vec3> position, std::size_t first, const Pencil& pencil, EyeMesh& mesh)
{
    const std::size_t lanes = hn::Lanes(Wide()), count = position.size();
    for (std::size_t v = 0; v < count; v += lanes) {
        float* corner = &mesh.corner[first + v].x;
        if (v + lanes <= count) {
            project<kSpace>(&position[v].x, pencil, corner);
        } else {
            float rest[3 * 64] = {};
            std::copy_n(&position[v].x, 3 * (count - v), rest);
            project<kSpace>(rest, pencil, corner); // the padding has room for a whole register
        }
    }
}

void project_range(
    std::span<const glm::vec3> position, std::size_t first, const Pencil& pencil, EyeMesh& mesh)
{
    if (mesh.corner_space == CornerSpace::eye)
        project_all<CornerSpace::eye>(position, first, pencil, mesh);
    else
        project_all<CornerSpace::flat>(position, first, pencil, mesh);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(project_range);

void project_vertices(std::span<const glm::vec3> position, const Pencil& pencil, EyeMesh& mesh,
    Tasks& tasks, CornerSpace space)
{
    constexpr std::size_t kPadding = 64;
    // Ranges are whole registers, so that no two threads write to the same one.
    constexpr std::size_t kGrain = 4096;
    mesh.corner_space = space;
    mesh.corner.resize(position.size() + kPadding);
    tasks.for_ranges(position.size(), kGrain, [&](std::size_t first, std::size_t last) {
        HWY_DYNAMIC_DISPATCH(project_range)
        (position.subspan(first, last - first), first, pencil, mesh);
    });
    if (pencil.parallel && space == CornerSpace::eye)
        mesh.cutouts.look_along(pencil, mesh.corner.span(), mesh.index);
}

} // namespace firsthit
#endif
