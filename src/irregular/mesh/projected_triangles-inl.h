// projected_triangles-inl.h - loads and tests one register of projected triangles.
#if defined(FIRSTHIT_IRREGULAR_MESH_PROJECTED_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_MESH_PROJECTED_TRIANGLES_INL_H_
#undef FIRSTHIT_IRREGULAR_MESH_PROJECTED_TRIANGLES_INL_H_
#else
#define FIRSTHIT_IRREGULAR_MESH_PROJECTED_TRIANGLES_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/mesh/pencil_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using ProjectedTag = hn::CappedTag<float, 16>;

/// Boxes and depths of ProjectedTriangle, one triangle a lane.
struct ProjectedTriangles {
    hn::Vec<ProjectedTag> x0, y0, x1, y1, nearest_w;
};

/// Loads as many triangles as a register has lanes. The memory is read in order and then shuffled:
/// a gather instruction for each field takes several times as long (measured on Zen 5).
HWY_INLINE ProjectedTriangles load_projected(const ProjectedTriangle* from)
{
    const ProjectedTag d;
    static_assert(sizeof(ProjectedTriangle) == 6 * sizeof(float));
#if HWY_TARGET == HWY_SCALAR
    const auto set = [&](float v) { return hn::Set(d, v); };
    return {set(from->x0), set(from->y0), set(from->x1), set(from->y1), set(from->nearest_w)};
#else
    // Pairs of fields: (triangle, x0), (y0, x1), (y1, nearest_w).
    const hn::Repartition<std::uint64_t, ProjectedTag> pairs;
    const auto* words = reinterpret_cast<const std::uint64_t*>(from);
    auto a0 = hn::Zero(pairs), b0 = a0, c0 = a0, a1 = a0, b1 = a0, c1 = a0;
    hn::LoadInterleaved3(pairs, words, a0, b0, c0);
    hn::LoadInterleaved3(pairs, words + 3 * hn::Lanes(pairs), a1, b1, c1);
    const auto first = [&](auto low, auto high) {
        return hn::ConcatEven(d, hn::BitCast(d, high), hn::BitCast(d, low));
    };
    const auto second = [&](auto low, auto high) {
        return hn::ConcatOdd(d, hn::BitCast(d, high), hn::BitCast(d, low));
    };
    return {second(a0, a1), first(b0, b1), second(b0, b1), first(c0, c1), second(c0, c1)};
#endif
}

/// Loads the triangles from index k on. Lanes past the end repeat the last triangle.
HWY_INLINE ProjectedTriangles load_projected(
    std::span<const ProjectedTriangle> triangles, std::size_t k)
{
    const std::size_t lanes = hn::Lanes(ProjectedTag());
    if (k + lanes <= triangles.size()) return load_projected(&triangles[k]);
    ProjectedTriangle spare[16];
    for (std::size_t i = 0; i < lanes; ++i)
        spare[i] = triangles[std::min(k + i, triangles.size() - 1)];
    return load_projected(spare);
}

/// may_hit, lane by lane.
HWY_INLINE hn::Mask<ProjectedTag> may_hit(const ProjectedTriangles& box, const SampleBounds& bounds)
{
    const ProjectedTag d;
    return hn::And(
        hn::And(hn::Le(box.x0, hn::Set(d, bounds.x1)), hn::Ge(box.x1, hn::Set(d, bounds.x0))),
        hn::And(
            hn::And(hn::Le(box.y0, hn::Set(d, bounds.y1)), hn::Ge(box.y1, hn::Set(d, bounds.y0))),
            hn::Not(hn::Lt(box.nearest_w, hn::Set(d, bounds.farthest_w)))));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
