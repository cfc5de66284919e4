// grid_shadows.cpp - which samples of a grid do triangles shadow?
//
// A triangle looks up the cells that its box meets. Most are done there: nothing in the parts of the
// cell that the box meets, or all of it nearer to the light. Of the samples in the box, those that
// an edge leaves out by more than its error are lit, and those inside by more than that are decided
// by the plane in double; the rest exactly.
//
// Edges: e = (b - a) x (p - a) of places (x, y), each off by at most u M, u = 2^-24, M the largest
// coordinate of the box (point lights; parallel light has no such error). With S = width + height of
// the box, in which p lies, this moves e by at most 4 u M S + 8 u^2 M^2; differences, products and
// their difference by 2 u S^2 more, fused or not.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/grid_shadows.cpp"
#include "base/simd.h"

#include "visibility/careful_box.h"
#include "visibility/grid_boxes-inl.h"
#include "visibility/grid_shadows.h"
#include "visibility/sample_registers-inl.h"
#include "visibility/seen_box-inl.h"
#include "visibility/shadow_plane.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Blocks = hn::CappedTag<float, GridBlock::kSamples>;
using BlockItems = hn::RebindToUnsigned<Blocks>;

constexpr std::uint32_t kMostCells = 256; // a triangle over more of them is not for the grid

/// What one task has at hand.
struct GridTest {
    const LightMesh& mesh;
    const SampleGrid& grid;
    const LightPoints& points;
    std::uint8_t* shadowed;
    ShadowCounts counts;
};

/// Threads may find the same sample shadowed.
HWY_INLINE bool is_marked(const GridTest& test, std::uint32_t id)
{
    return std::atomic_ref(test.shadowed[id]).load(std::memory_order_relaxed) != 0;
}
HWY_INLINE void mark(const GridTest& test, std::uint32_t id)
{
    std::atomic_ref(test.shadowed[id]).store(1, std::memory_order_relaxed);
}

/// The bound of an edge's error, for points inside the box.
HWY_INLINE float edge_error(const LightMesh& mesh, const SeenBox& box)
{
    const float size = (box.high[0] - box.low[0]) + (box.high[1] - box.low[1]);
    const float largest = std::max(std::max(std::abs(box.low[0]), std::abs(box.high[0])),
        std::max(std::abs(box.low[1]), std::abs(box.high[1])));
    const float moved = mesh.space.directional ? 0 : largest * (size + 0x1p-21f * largest);
    return 6 * 0x1p-24f * (moved + 0.5f * size * size) + 0x1p-120f;
}

/// Samples inside of all edges, or nearly: a bit each in `maybe`, and in `inside` those certainly.
struct Inside {
    std::uint32_t maybe, inside;
};

HWY_INLINE Inside inside_edges(const GridTest& test, const SeenBox& box, const GridBlock& block)
{
    const Blocks d;
    const glm::uvec3& index = test.mesh.index[box.triangle];
    const SeenPoint &a = test.mesh.seen[index.x], &b = test.mesh.seen[index.y],
                    &c = test.mesh.seen[index.z];
    const float error = edge_error(test.mesh, box);
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(area) > error)) return {~0u, 0};
    const float side = area < 0 ? -1.0f : 1.0f;
    const auto edge = [&](const SeenPoint& from, const SeenPoint& to, auto px, auto py) {
        const auto dx = hn::Set(d, side * (to.x - from.x)), dy = hn::Set(d, side * (to.y - from.y));
        return hn::Sub(hn::Mul(dx, hn::Sub(py, hn::Set(d, from.y))),
            hn::Mul(dy, hn::Sub(px, hn::Set(d, from.x))));
    };
    // No number counts as maybe.
    const auto below = hn::Set(d, -error), above = hn::Set(d, error);
    Inside found{0, 0};
    for (std::size_t k = 0; k < GridBlock::kSamples; k += hn::Lanes(d)) {
        const auto px = hn::Load(d, block.x + k), py = hn::Load(d, block.y + k);
        const auto e0 = edge(a, b, px, py), e1 = edge(b, c, px, py), e2 = edge(c, a, px, py);
        const auto outside =
            hn::Or(hn::Lt(e0, below), hn::Or(hn::Lt(e1, below), hn::Lt(e2, below)));
        const auto within =
            hn::And(hn::Gt(e0, above), hn::And(hn::Gt(e1, above), hn::Gt(e2, above)));
        found.maybe |= std::uint32_t(bits(d, hn::Not(outside))) << k;
        found.inside |= std::uint32_t(bits(d, within)) << k;
    }
    return found;
}

/// Decides the samples of a block, a bit each in `open`, that lie in the triangle's box.
HWY_NOINLINE void settle(
    GridTest& test, const SeenBox& box, std::uint32_t number, std::uint32_t open)
{
    const GridBlock& block = test.grid.blocks[number];
    const Inside edges = inside_edges(test, box, block);
    open &= edges.maybe;
    if (open == 0) return;
    const ShadowPlane plane(test.mesh, box.triangle);
    for (; open; open &= open - 1) {
        const std::uint32_t lane = std::uint32_t(std::countr_zero(open));
        const std::uint32_t id = test.grid.id[number * GridBlock::kSamples + lane];
        if (id == kNoSample || is_marked(test, id)) continue;
        const Certain certain = plane.behind(block.x[lane], block.y[lane], block.w[lane]);
        if (certain == Certain::lit) continue;
        if (certain == Certain::shadowed && (edges.inside >> lane & 1)) {
            mark(test, id);
            continue;
        }
        ++test.counts.uncertain;
        if (is_shadowed(test.mesh.space, test.mesh.corners(box.triangle),
                test.points.in_light_space(id), test.counts.effort))
            mark(test, id);
    }
}

/// Calls f(coarse cell, rect inside of it) for the coarse cells of a box.
template <class F>
HWY_INLINE void for_coarse(const GridRect& rect, const F& f)
{
    const auto inner = [](std::uint32_t v, std::uint32_t coarse) {
        const std::uint32_t from = coarse << kFineBits;
        return std::uint16_t(v < from ? 0 : std::min(v - from, kFineMask));
    };
    for (std::uint32_t y = rect.y0 >> kFineBits; y <= rect.y1 >> kFineBits; ++y)
        for (std::uint32_t x = rect.x0 >> kFineBits; x <= rect.x1 >> kFineBits; ++x)
            f(y << kCoarseBits | x, GridRect{inner(rect.x0, x), inner(rect.y0, y),
                                        inner(rect.x1, x), inner(rect.y1, y)});
}

/// Triangles that go through the grid together: every step is done for all of them, and what it
/// leaves is a list for the next one, so that nothing jumps where it is not foreseen.
struct GridBatch {
    /// Samples of one cell.
    struct Meeting {
        std::uint32_t triangle;
        std::uint32_t first, last; // blocks
    };
    /// Samples in the triangle's box, not nearer to the light than all of it.
    struct Open {
        std::uint32_t triangle;
        std::uint32_t block;
        std::uint32_t bits;
    };
    GridBoxes boxes;
    std::size_t wide_count = 0, meeting_count = 0;
    std::uint32_t wide[GridBoxes::kRoom]; // of the boxes: over more than 2 x 2 cells
    Meeting meeting[4 * GridBoxes::kTriangles + kMostCells];
};

/// The number of the coarse cell of a place.
HWY_INLINE std::uint32_t coarse_of(std::uint32_t x, std::uint32_t y)
{
    return y >> kFineBits << kCoarseBits | x >> kFineBits;
}

/// The bits first to last of 16.
HWY_INLINE std::uint32_t bits_between(std::uint32_t first, std::uint32_t last)
{
    return (0xFFFFu >> (15 - last)) & (0xFFFFu << first);
}

/// The parts of a cell in the columns and rows whose bits are set; rows lie side by side.
HWY_INLINE std::uint64_t parts_of(std::uint32_t columns, std::uint64_t rows)
{
    return columns * 0x0101010101010101u & rows;
}
HWY_INLINE std::uint64_t rows_between(std::uint32_t first, std::uint32_t last)
{
    return (~std::uint64_t(0) << (8 * first)) & (~std::uint64_t(0) >> (8 * (7 - last)));
}

/// Adds the cell's samples where it has some in these parts that the triangle may shadow.
HWY_INLINE void meet_cell(
    const GridCell* cell, std::uint64_t parts, std::size_t number, GridBatch& batch)
{
    const GridBoxes& boxes = batch.boxes;
    const unsigned meets = unsigned((cell->occupied & parts) != 0) &
                           unsigned(cell->farthest_w <= boxes.nearest_w[number]);
    batch.meeting[batch.meeting_count] = {
        std::uint32_t(boxes.first + number), cell[0].first, cell[1].first};
    batch.meeting_count += meets;
}

/// Looks up the cells of all boxes but wide ones.
HWY_NOINLINE void look_up_cells(const SampleGrid& grid, GridBatch& batch)
{
    const GridBoxes& boxes = batch.boxes;
    batch.meeting_count = batch.wide_count = 0;
    for (std::size_t k = 0; k < boxes.single_count; ++k) {
        const std::size_t i = boxes.single[k];
        meet_cell(&grid.cells[boxes.cell[i]], boxes.parts[i], i, batch);
    }
    for (std::size_t k = 0; k < boxes.other_count; ++k) {
        const std::size_t i = boxes.other[k];
        const GridRect& rect = boxes.rect[i];
        const std::uint32_t x0 = rect.x0, y0 = rect.y0, x1 = rect.x1, y1 = rect.y1;
        const CoarseCell& coarse = grid.coarse[coarse_of(x0, y0)];
        const std::uint32_t level = coarse.level, shift = kFineBits - level,
                            part = kMostLevels - level;
        const std::uint32_t columns = (x1 >> shift) - (x0 >> shift),
                            rows = (y1 >> shift) - (y0 >> shift);
        const bool one_coarse = (((x0 ^ x1) | (y0 ^ y1)) >> kFineBits) == 0;
        batch.wide[batch.wide_count] = std::uint32_t(i);
        if (one_coarse && boxes.nearest_w[i] < coarse.farthest_w) continue;
        if (!one_coarse || (columns | rows) > 1) {
            ++batch.wide_count;
            continue;
        }
        const std::uint32_t x_bits = bits_between(x0 >> part & 7, (x1 >> part & 7) + 8 * columns);
        const std::uint32_t y_part0 = y0 >> part & 7, y_part1 = y1 >> part & 7;
        const std::uint64_t upper = rows_between(y_part0, rows ? 7 : y_part1),
                            lower = rows ? rows_between(0, y_part1) : 0;
        const GridCell* cell = &grid.cells[coarse.first + ((y0 & kFineMask) >> shift << level) +
                                           ((x0 & kFineMask) >> shift)];
        const GridCell* below = cell + (std::size_t(1) << level);
        meet_cell(cell, parts_of(x_bits & 0xFF, upper), i, batch);
        meet_cell(cell + 1, parts_of(x_bits >> 8, upper), i, batch);
        meet_cell(below, parts_of(x_bits & 0xFF, lower), i, batch);
        meet_cell(below + 1, parts_of(x_bits >> 8, lower), i, batch);
    }
}

/// The samples of a block that lie in the box, and not nearer to the light than all of it, on other
/// triangles: a bit each.
HWY_INLINE std::uint32_t samples_in(const SeenBox& box, const GridBlock& block)
{
    const Blocks d;
    const BlockItems n;
    std::uint32_t chosen = 0;
    for (std::size_t k = 0; k < GridBlock::kSamples; k += hn::Lanes(d)) {
        const auto x = hn::Load(d, block.x + k), y = hn::Load(d, block.y + k),
                   w = hn::Load(d, block.w + k);
        // Differences have the signs of comparisons.
        const auto beside =
            hn::Max(hn::Sub(hn::Set(d, box.low[0]), x), hn::Sub(x, hn::Set(d, box.high[0])));
        const auto above =
            hn::Max(hn::Sub(hn::Set(d, box.low[1]), y), hn::Sub(y, hn::Set(d, box.high[1])));
        const auto before = hn::Sub(w, hn::Set(d, box.nearest_w()));
        const auto out = hn::Max(hn::Max(beside, above), before);
        const auto other =
            hn::RebindMask(d, hn::Ne(hn::Load(n, block.item + k), hn::Set(n, box.triangle)));
        chosen |= std::uint32_t(bits(d, hn::And(hn::Le(out, hn::Zero(d)), other))) << k;
    }
    return chosen;
}

/// The samples of the meetings against their triangles.
HWY_NOINLINE void test_meetings(GridTest& test, GridBatch& batch)
{
    constexpr std::size_t kRoom = 64;
    GridBatch::Open open[kRoom + 1];
    std::size_t count = 0, tested = 0;
    const auto settle_all = [&] {
        for (std::size_t k = 0; k < count; ++k)
            settle(test, seen_box(test.mesh, open[k].triangle), open[k].block, open[k].bits);
        count = 0;
    };
    for (const GridBatch::Meeting& meeting : std::span(batch.meeting, batch.meeting_count)) {
        const SeenBox box = seen_box(test.mesh, meeting.triangle);
        for (std::uint32_t k = meeting.first; k < meeting.last; ++k) {
            const std::uint32_t chosen = samples_in(box, test.grid.blocks[k]);
            open[count] = {meeting.triangle, k, chosen};
            count += chosen != 0;
            if (count == kRoom) settle_all();
            ++tested;
        }
    }
    settle_all();
    test.counts.pairs += tested * GridBlock::kSamples;
}

/// The number of cells that a box meets, up to about kMostCells.
std::uint32_t count_cells(const SampleGrid& grid, const GridRect& rect)
{
    const std::uint32_t x0 = rect.x0 >> kFineBits, x1 = rect.x1 >> kFineBits,
                        y0 = rect.y0 >> kFineBits, y1 = rect.y1 >> kFineBits;
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > kMostCells) return kMostCells + 1;
    std::uint32_t count = 0;
    for_coarse(rect, [&](std::uint32_t coarse, const GridRect& inner) {
        const std::uint32_t shift = kFineBits - grid.coarse[coarse].level;
        count += ((inner.x1 >> shift) - (inner.x0 >> shift) + 1u) *
                 ((inner.y1 >> shift) - (inner.y0 >> shift) + 1u);
    });
    return count;
}

/// All cells of a box, where these are not too many: else false.
bool look_up_wide(const SampleGrid& grid, std::uint32_t number, GridBatch& batch)
{
    const GridRect& rect = batch.boxes.rect[number];
    if (count_cells(grid, rect) > kMostCells) return false;
    for_coarse(rect, [&](std::uint32_t coarse, const GridRect& inner) {
        if (grid.coarse[coarse].farthest_w > batch.boxes.nearest_w[number]) return;
        const std::uint32_t level = grid.coarse[coarse].level;
        const std::uint32_t shift = kFineBits - level, part = kMostLevels - level;
        const std::uint32_t column0 = inner.x0 >> shift, column1 = inner.x1 >> shift,
                            row0 = inner.y0 >> shift, row1 = inner.y1 >> shift;
        for (std::uint32_t row = row0; row <= row1; ++row) {
            const std::uint64_t rows = rows_between(
                row == row0 ? inner.y0 >> part & 7 : 0, row == row1 ? inner.y1 >> part & 7 : 7);
            const GridCell* cells = &grid.cells[grid.coarse[coarse].first + (row << level)];
            for (std::uint32_t column = column0; column <= column1; ++column) {
                const std::uint32_t columns =
                    bits_between(column == column0 ? inner.x0 >> part & 7 : 0,
                        column == column1 ? inner.x1 >> part & 7 : 7);
                meet_cell(&cells[column], parts_of(columns, rows), number, batch);
            }
        }
    });
    return true;
}

void test_range(LightMesh& mesh, std::size_t range, const SampleGrid& grid,
    const LightPoints& points, std::uint8_t* shadowed, ShadowCounts& counts)
{
    const std::size_t first = range * kLightRange,
                      last = std::min(mesh.index.size(), first + kLightRange);
    SeenTriangle* left = &mesh.in_view[first];
    GridTest test{mesh, grid, points, shadowed, {}};
    GridBatch batch;
    for (std::size_t t = first; t < last; t += GridBoxes::kTriangles) {
        sort_boxes(mesh, grid, t, std::min(last, t + GridBoxes::kTriangles), batch.boxes);
        look_up_cells(grid, batch);
        test_meetings(test, batch);
        for (std::size_t k = 0; k < batch.wide_count; ++k) {
            batch.meeting_count = 0;
            if (look_up_wide(grid, batch.wide[k], batch)) {
                test_meetings(test, batch);
                continue;
            }
            const SeenBox box = seen_box(mesh, std::uint32_t(t + batch.wide[k]));
            *left++ = {
                box.triangle, box.low[0], box.low[1], box.high[0], box.high[1], box.nearest_w()};
        }
        for (std::size_t k = 0; k < batch.boxes.unseen_count; ++k) {
            SeenTriangle unseen{std::uint32_t(t + batch.boxes.unseen[k]), 0, 0, 0, 0, 0};
            if (see_careful(mesh.face, mesh.corners(unseen.triangle), unseen) &&
                may_shadow(unseen, grid.bounds))
                *left++ = unseen;
        }
        test.counts.triangles += batch.boxes.single_count + batch.boxes.other_count;
    }
    mesh.range_count[range] = std::uint32_t(left - &mesh.in_view[first]);
    counts.add(test.counts);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(test_range);

std::size_t test_grid(LightMesh& mesh, const SampleGrid& grid, const LightPoints& points,
    std::span<GridShadowCounts> counts, Tasks& tasks, std::span<std::uint8_t> shadowed)
{
    tasks.for_each(mesh.range_count.size(), [&](std::size_t range, std::size_t worker) {
        HWY_DYNAMIC_DISPATCH(test_range)
        (mesh, range, grid, points, shadowed.data(), counts[worker].counts);
    });
    std::size_t left = 0;
    for (const std::uint32_t count : mesh.range_count.span()) left += count;
    return left;
}

} // namespace firsthit
#endif
