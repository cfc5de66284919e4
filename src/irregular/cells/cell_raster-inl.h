// cell_raster-inl.h - tests a batch of triangles, once it is set up, against the groups of a cell.
#if defined(FIRSTHIT_IRREGULAR_CELLS_CELL_RASTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_CELLS_CELL_RASTER_INL_H_
#undef FIRSTHIT_IRREGULAR_CELLS_CELL_RASTER_INL_H_
#else
#define FIRSTHIT_IRREGULAR_CELLS_CELL_RASTER_INL_H_
#endif

#include "base/undefined_lanes.h"
#include "irregular/mesh/gather_corners.h"
#include "irregular/cells/cell_samples-inl.h"
#include "irregular/cells/set_up-inl.h"
#include "visibility/raster/sample_registers-inl.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// What the tests of a cell's triangles need.
struct CellTest {
    const PencilMesh& mesh;
    std::span<const IrregularSample> samples;
    const PencilPoints& points;
    float edge_error; // cell_edge_error
};

/// Tests the samples of a group whose bits are set in `open` with is_shadowed, one at a time.
/// Returns the bits of those that are shadowed.
HWY_NOINLINE inline std::uint32_t decide_group_exactly(const CellTest& cell, std::uint32_t triangle,
    std::size_t group, std::uint32_t open, CellKernelMemory& kernel)
{
    const PencilMesh& mesh = cell.mesh;
    const Corners corners = mesh.corners(triangle);
    std::uint32_t shadowed = 0;
    for (; open; open &= open - 1) {
        const std::size_t k = kernel.first[group] + std::size_t(std::countr_zero(open));
        if (k >= kernel.first[group + 1]) break;
        ++kernel.counts.uncertain;
        const glm::vec3 d = cell.points.in_pencil_space(cell.samples[k].id);
        if (is_shadowed(mesh.space, mesh.cutouts, {triangle, corners}, d, kernel.counts.effort))
            shadowed |= open & (~open + 1);
    }
    return shadowed;
}

/// The items of a group's samples, kNoItem after the last one. They are loaded the first time that
/// they are needed, because most groups never need them.
HWY_INLINE const std::uint32_t* items_of(
    const CellTest& cell, std::size_t group, CellKernelMemory& kernel)
{
    std::uint32_t* items = kernel.item.data() + group * kGroup;
    if (kernel.has_item[group]) return items;
    kernel.has_item[group] = 1;
    const std::size_t first = kernel.first[group], count = kernel.first[group + 1] - first;
    for (std::size_t k = 0; k < kGroup; ++k)
        items[k] = cell.points.item && k < count ? cell.points.item[cell.samples[first + k].id]
                                                 : 0xFFFFFFFFu;
    return items;
}

/// Tests triangle i of the batch against the groups of a chunk whose bits are set.
HWY_INLINE void test_groups(
    const CellTest& cell, int i, std::size_t chunk, std::uint64_t groups, CellKernelMemory& kernel)
{
    const Group d;
    const hn::RebindToUnsigned<Group> du;
    constexpr int lanes = int(hn::MaxLanes(Group()));
    const CellBatch& batch = kernel.batch;
    const auto gx0 = hn::Set(d, batch.gx[0][i]), gy0 = hn::Set(d, batch.gy[0][i]),
               c0 = hn::Set(d, batch.c[0][i]), gx1 = hn::Set(d, batch.gx[1][i]),
               gy1 = hn::Set(d, batch.gy[1][i]), c1 = hn::Set(d, batch.c[1][i]),
               gx2 = hn::Set(d, batch.gx[2][i]), gy2 = hn::Set(d, batch.gy[2][i]),
               c2 = hn::Set(d, batch.c[2][i]);
    const auto wx = hn::Set(d, batch.wx[i]), wy = hn::Set(d, batch.wy[i]),
               wc = hn::Set(d, batch.wc[i]);
    const auto shadowed_from = hn::Set(d, batch.shadowed_from[i]),
               lit_below = hn::Set(d, batch.lit_below[i]);
    const auto inside_from = hn::Set(d, cell.edge_error), maybe_from = hn::Set(d, -cell.edge_error);
    const auto triangle = hn::Set(du, batch.triangle[i]);
    OverlapTable& table = kernel.table[chunk];

    kernel.counts.pairs += std::uint64_t(std::popcount(groups)) * kGroup;
    for (; groups; groups &= groups - 1) {
        const std::size_t group = chunk * kTableBoxes + std::size_t(std::countr_zero(groups));
        std::uint32_t shadowed = kernel.shadowed[group];
        const std::uint32_t before = shadowed;
        for (int offset = 0; offset < kGroup; offset += lanes) {
            const std::size_t k = group * kGroup + std::size_t(offset);
            const auto x = hn::Load(d, kernel.x.data() + k), y = hn::Load(d, kernel.y.data() + k);
            const auto e0 = hn::MulAdd(gx0, x, hn::MulAdd(gy0, y, c0));
            const auto e1 = hn::MulAdd(gx1, x, hn::MulAdd(gy1, y, c1));
            const auto e2 = hn::MulAdd(gx2, x, hn::MulAdd(gy2, y, c2));
            const auto least = hn::Min(e0, hn::Min(e1, e2));
            const auto ahead =
                hn::Sub(hn::MulAdd(wx, x, hn::MulAdd(wy, y, wc)), hn::Load(d, kernel.w.data() + k));
            // A comparison with NaN is false, so `maybe` is set where `ahead` is NaN.
            const auto maybe = hn::AndNot(hn::Lt(ahead, lit_below), hn::Gt(least, maybe_from));
            if (hn::AllFalse(d, maybe)) continue;
            const auto other = hn::RebindMask(
                d, hn::Ne(hn::Load(du, items_of(cell, group, kernel) + offset), triangle));
            const auto certain =
                hn::And(hn::And(hn::Gt(least, inside_from), hn::Gt(ahead, shadowed_from)), other);
            const std::uint32_t hit = std::uint32_t(bits(d, certain)) << offset;
            const std::uint32_t open =
                std::uint32_t(bits(d, hn::And(maybe, other))) << offset & ~hit & ~shadowed;
            shadowed |= hit;
            if (open) [[unlikely]]
                shadowed |= decide_group_exactly(cell, batch.triangle[i], group, open, kernel);
        }
        if (shadowed == before) continue;
        kernel.shadowed[group] = std::uint16_t(shadowed);
        if (shadowed == 0xFFFF) table.open &= ~(groups & (~groups + 1));
    }
}

/// Removes the groups of a chunk that lie wholly outside of an edge of triangle i. Worth its cost
/// for a triangle whose box overlaps many groups, such as a long thin one across the cell.
HWY_INLINE std::uint64_t groups_inside(const CellTest& cell, int i, std::size_t chunk,
    std::uint64_t groups, const CellKernelMemory& kernel)
{
    const Group d;
    const CellBatch& batch = kernel.batch;
    const auto outside_below = hn::Set(d, -2 * cell.edge_error);
    const auto half = hn::Set(d, 0.5f), room = hn::Set(d, 1 + 0x1p-20f);
    std::uint64_t inside = 0;
    for (std::size_t k = 0; k < kTableBoxes; k += hn::Lanes(d)) {
        const std::size_t at = chunk * kTableBoxes + k;
        auto x0 = half, minus_x1 = half, y0 = half, minus_y1 = half;
        may_be_undefined(
            &kernel.box[at], hn::Lanes(d) * sizeof kernel.box[at]); // past the last group
        hn::LoadInterleaved4(d, kernel.box[at].side, x0, minus_x1, y0, minus_y1);
        // The middle of each box, and the largest distance of a sample from it.
        const auto x = hn::Mul(half, hn::Sub(x0, minus_x1)),
                   y = hn::Mul(half, hn::Sub(y0, minus_y1));
        const auto rx = hn::Mul(room, hn::Max(hn::Sub(hn::Neg(minus_x1), x), hn::Sub(x, x0)));
        const auto ry = hn::Mul(room, hn::Max(hn::Sub(hn::Neg(minus_y1), y), hn::Sub(y, y0)));
        auto most = hn::Set(d, 1.0f);
        for (int e = 0; e < 3; ++e) {
            const auto gx = hn::Set(d, batch.gx[e][i]), gy = hn::Set(d, batch.gy[e][i]);
            const auto middle = hn::MulAdd(gx, x, hn::MulAdd(gy, y, hn::Set(d, batch.c[e][i])));
            const auto reach = hn::MulAdd(hn::Abs(gx), rx, hn::Mul(hn::Abs(gy), ry));
            most = hn::Min(most, hn::Add(middle, reach));
        }
        inside |= bits(d, hn::Not(hn::Lt(most, outside_below))) << k;
    }
    return groups & inside;
}

/// Leaves all samples that a cut-out of the batch may shadow to the exact test.
inline void leave_cutouts_open(const Cutouts& cutouts, CellBatch& batch)
{
    for (int i = 0; i < batch.count; ++i)
        if (cutouts.has(batch.triangle[i]))
            batch.shadowed_from[i] = std::numeric_limits<float>::infinity();
}

/// Sets up the triangles of the batch, tests them against the groups, and empties the batch.
inline void test_batch(const CellTest& cell, CellKernelMemory& kernel)
{
    constexpr int kManyGroups = 12;
    const hn::CappedTag<double, 8> d;
    CellBatch& batch = kernel.batch;
    gather_corners(cell.mesh, cell.mesh.face, batch.count, batch.triangle, batch.corner);
    for (int i = 0; i < batch.count; i += int(hn::Lanes(d)))
        set_up_cell_lanes(d, cell.mesh.space.directional, kernel, i);
    if (cell.mesh.cutouts.any()) leave_cutouts_open(cell.mesh.cutouts, batch);
    for (int i = 0; i < batch.count; ++i) {
        for (std::size_t chunk = 0; chunk < kernel.table.size(); ++chunk) {
            std::uint64_t groups = kernel.table[chunk].of(batch.slots[i]);
            if (std::popcount(groups) >= kManyGroups)
                groups = groups_inside(cell, i, chunk, groups, kernel);
            if (groups) test_groups(cell, i, chunk, groups, kernel);
        }
    }
    kernel.counts.triangles += std::uint64_t(batch.count);
    batch.count = 0;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
