// decide_pairs-inl.h - decides pairs of a triangle and a sample that quantized coordinates left
// open: edges in float, one pair a lane; then the plane in double; then the exact test.
//
// Error of an edge e = (b - a) x (p - a), with u = 2^-24 the relative error of a float. In a pencil
// with an origin, each coordinate is off by at most u M, M being the largest coordinate of the
// triangle's box. S is width + height of the box, in which p lies. This changes e by at most 4 u M
// S + 8 u^2 M^2. In a parallel pencil coordinates have no error. Differences, products and the
// difference of these add at most 2 u S^2, fused or not.
#if defined(FIRSTHIT_IRREGULAR_GRID_DECIDE_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_GRID_DECIDE_PAIRS_INL_H_
#undef FIRSTHIT_IRREGULAR_GRID_DECIDE_PAIRS_INL_H_
#else
#define FIRSTHIT_IRREGULAR_GRID_DECIDE_PAIRS_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/grid/sample_grid.h"
#include "irregular/mesh/project_lanes_to_face-inl.h"
#include "irregular/shadow_plane.h"
#include "visibility/raster/sample_registers-inl.h"

#include <atomic>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What one task tests, and its counts.
struct GridTest {
    const PencilMesh& mesh;
    const SampleGrid& grid;
    const PencilPoints& points;
    std::uint8_t* shadowed;
    TestCounts counts;
};

/// Pairs of a triangle and a sample that it may shadow; the sample does not lie on the triangle.
struct GridPairs {
    static constexpr std::size_t kMost = 256;
    static constexpr std::size_t kCapacity = kMost + 16;
    std::size_t count = 0;
    std::uint32_t triangle[kCapacity];
    std::uint32_t sample[kCapacity]; // index in the grid's order
};

/// Accesses shadowed[id] atomically, because several tasks may find the same sample shadowed.
HWY_INLINE bool is_marked(const GridTest& test, std::uint32_t id)
{
    return std::atomic_ref(test.shadowed[id]).load(std::memory_order_relaxed) != 0;
}
HWY_INLINE void mark(const GridTest& test, std::uint32_t id)
{
    std::atomic_ref(test.shadowed[id]).store(1, std::memory_order_relaxed);
}

using Pairs = hn::CappedTag<float, 16>;

/// A register of pairs: corners in the pencil's space, and projected samples.
struct PairLanes {
    alignas(64) float corner[9][16];
    alignas(64) float x[16], y[16], w[16];
};

HWY_INLINE void fill_lanes(
    const GridTest& test, const GridPairs& pairs, std::size_t first, PairLanes& lanes)
{
    for (std::size_t k = 0; k < hn::Lanes(Pairs()); ++k) {
        const std::size_t pair = std::min(first + k, pairs.count - 1);
        const glm::uvec3& index = test.mesh.index[pairs.triangle[pair]];
        for (int c = 0; c < 3; ++c) {
            const glm::vec3& p = test.mesh.corner[index[c]];
            lanes.corner[3 * c][k] = p.x;
            lanes.corner[3 * c + 1][k] = p.y;
            lanes.corner[3 * c + 2][k] = p.z;
        }
        const IrregularSample& sample =
            test.grid.samples[test.grid.sample_index[pairs.sample[pair]]];
        lanes.x[k] = sample.x, lanes.y[k] = sample.y, lanes.w[k] = sample.w;
        __builtin_prefetch(&test.shadowed[sample.id]);
    }
}

/// Bit k of `maybe` is set unless pair k's sample is certainly outside of an edge, outside of the
/// box or in front of the whole triangle. Bit k of `inside` is set if the sample is certainly
/// inside all edges.
struct Inside {
    std::uint32_t maybe, inside;
};

HWY_INLINE Inside inside_edges(const CubeFace& face, const PairLanes& lanes)
{
    const Pairs d;
    using V = hn::Vec<Pairs>;
    const auto corner = [&](int k) {
        const auto load = [&](int axis) { return hn::Load(d, lanes.corner[3 * k + axis]); };
        return project_lanes_to_face(d, face, load(0), load(1), load(2));
    };
    const ProjectedLanes<Pairs> a = corner(0), b = corner(1), c = corner(2);
    const V px = hn::Load(d, lanes.x), py = hn::Load(d, lanes.y), w = hn::Load(d, lanes.w);
    const V x0 = hn::Min(hn::Min(a.x, b.x), c.x), x1 = hn::Max(hn::Max(a.x, b.x), c.x),
            y0 = hn::Min(hn::Min(a.y, b.y), c.y), y1 = hn::Max(hn::Max(a.y, b.y), c.y);
    const V size = hn::Add(hn::Sub(x1, x0), hn::Sub(y1, y0));
    const V largest = hn::Max(hn::Max(hn::Abs(x0), hn::Abs(x1)), hn::Max(hn::Abs(y0), hn::Abs(y1)));
    V moved = hn::Zero(d);
    if (!face.directional)
        moved = hn::Mul(largest, hn::Add(size, hn::Mul(hn::Set(d, 0x1p-21f), largest)));
    const V error = hn::Add(hn::Mul(hn::Set(d, 6 * 0x1p-24f),
                                hn::Add(moved, hn::Mul(hn::Set(d, 0.5f), hn::Mul(size, size)))),
        hn::Set(d, 0x1p-120f));
    const auto cross = [&](const ProjectedLanes<Pairs>& from, const ProjectedLanes<Pairs>& to, V x,
                           V y) {
        return hn::Sub(hn::Mul(hn::Sub(to.x, from.x), hn::Sub(y, from.y)),
            hn::Mul(hn::Sub(to.y, from.y), hn::Sub(x, from.x)));
    };
    const V area = cross(a, b, c.x, c.y);
    const auto sided = hn::Gt(hn::Abs(area), error);
    const auto edge = [&](const ProjectedLanes<Pairs>& from, const ProjectedLanes<Pairs>& to) {
        const V e = cross(from, to, px, py);
        return hn::IfThenElse(hn::Lt(area, hn::Zero(d)), hn::Neg(e), e);
    };
    const V e0 = edge(a, b), e1 = edge(b, c), e2 = edge(c, a), below = hn::Neg(error);
    // Comparisons with NaN are false, so NaN counts as maybe.
    const auto outside =
        hn::And(sided, hn::Or(hn::Lt(e0, below), hn::Or(hn::Lt(e1, below), hn::Lt(e2, below))));
    const auto within =
        hn::And(sided, hn::And(hn::Gt(e0, error), hn::And(hn::Gt(e1, error), hn::Gt(e2, error))));
    const auto beside =
        hn::Or(hn::Or(hn::Lt(px, x0), hn::Gt(px, x1)), hn::Or(hn::Lt(py, y0), hn::Gt(py, y1)));
    const auto before = hn::Gt(w, hn::Max(hn::Max(a.w, b.w), c.w));
    const auto maybe = hn::Not(hn::Or(outside, hn::Or(beside, before)));
    return {std::uint32_t(bits(d, maybe)), std::uint32_t(bits(d, within))};
}

/// Decides all pairs, marks the samples that are shadowed, and empties the list.

HWY_NOINLINE inline void decide_pairs(GridTest& test, GridPairs& pairs)
{
    const std::size_t lanes = hn::Lanes(Pairs());
    for (std::size_t k = 0; k < pairs.count; ++k) {
        __builtin_prefetch(&test.grid.samples[test.grid.sample_index[pairs.sample[k]]]);
        const glm::uvec3& index = test.mesh.index[pairs.triangle[k]];
        for (int c = 0; c < 3; ++c) __builtin_prefetch(&test.mesh.corner[index[c]]);
    }
    PairLanes some;
    for (std::size_t first = 0; first < pairs.count; first += lanes) {
        fill_lanes(test, pairs, first, some);
        const Inside edges = inside_edges(test.mesh.face, some);
        std::uint32_t open = edges.maybe;
        if (pairs.count - first < lanes) open &= (1u << (pairs.count - first)) - 1;
        for (; open; open &= open - 1) {
            const std::uint32_t lane = std::uint32_t(std::countr_zero(open));
            const std::uint32_t triangle = pairs.triangle[first + lane];
            const std::uint32_t number = test.grid.sample_index[pairs.sample[first + lane]];
            const std::uint32_t id = test.grid.samples[number].id;
            if (is_marked(test, id)) continue;
            const Verdict verdict =
                ShadowPlane(test.mesh, triangle).classify(some.x[lane], some.y[lane], some.w[lane]);
            if (verdict == Verdict::lit) continue;
            if (verdict == Verdict::shadowed && (edges.inside >> lane & 1) &&
                !test.mesh.cutouts.has(triangle)) {
                mark(test, id);
                continue;
            }
            ++test.counts.uncertain;
            if (is_shadowed(test.mesh.space, test.mesh.cutouts,
                    {triangle, test.mesh.corners(triangle)}, test.points.in_pencil_space(id),
                    test.counts.effort))
                mark(test, id);
        }
    }
    pairs.count = 0;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
