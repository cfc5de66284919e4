// cell_kernel.cpp - tests the samples of one cell of the irregular z-buffer against the cell's
// triangles.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/cells/cell_kernel.cpp"
#include "base/simd.h"

#include "irregular/cells/cell_kernel.h"
#include "irregular/cells/cell_raster-inl.h"
#include "irregular/mesh/projected_triangles-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// The triangle with its box relative to (x, y).
HWY_INLINE ProjectedTriangle moved(const ProjectedTriangle& box, float x, float y)
{
    return {box.triangle, box.x0 - x, box.y0 - y, box.x1 - x, box.y1 - y, box.nearest_w};
}

/// The slots (overlap_table.h) of sixteen triangles: rows x0, y0, x1, y1 and nearest w.
struct SlotRegister {
    alignas(64) std::int32_t slot[5][kGroup];
};

/// What is subtracted from coordinates before they become slots.
struct Middle {
    float x, y;
};

/// Fills in the slots of the first sixteen triangles, or of all if there are fewer: the lanes after
/// the last one are garbage. Returns a bit for each triangle, set if it may be hit (may_hit).
HWY_INLINE std::uint32_t find_slots(std::span<const ProjectedTriangle> triangles,
    const SampleBounds& bounds, const Middle& middle, const BoxSlots& slots, SlotRegister& found)
{
    const Group d;
    const hn::RebindToSigned<Group> w;
    const int lanes = int(hn::Lanes(d));
    const auto slot_of = [&](auto v, const Slots& axis) { // the same as Slots::of
        const auto at = hn::Mul(hn::Sub(v, hn::Set(d, axis.start)), hn::Set(d, axis.scale));
        const auto inside = hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), at);
        return hn::ConvertTo(w, hn::Min(inside, hn::Set(d, float(kSlots - 1))));
    };
    std::uint32_t chosen = 0;
    for (int k = 0; k < kGroup; k += lanes) {
        const ProjectedTriangles box = load_projected(triangles, std::size_t(k));
        chosen |= std::uint32_t(bits(d, may_hit(box, bounds))) << k;
        const auto x = hn::Set(d, middle.x), y = hn::Set(d, middle.y);
        hn::Store(slot_of(hn::Sub(box.x0, x), slots.x), w, found.slot[0] + k);
        hn::Store(slot_of(hn::Sub(box.y0, y), slots.y), w, found.slot[1] + k);
        hn::Store(slot_of(hn::Sub(box.x1, x), slots.x), w, found.slot[2] + k);
        hn::Store(slot_of(hn::Sub(box.y1, y), slots.y), w, found.slot[3] + k);
        hn::Store(slot_of(box.nearest_w, slots.w), w, found.slot[4] + k);
    }
    if (triangles.size() < kGroup) chosen &= (1u << triangles.size()) - 1;
    return chosen;
}

/// Whether the triangle may shadow a sample of any group that is not wholly shadowed yet.
HWY_INLINE bool overlaps_open_group(const CellKernelMemory& kernel, const TriangleSlots& box)
{
    std::uint64_t any = 0;
    for (const OverlapTable& table : kernel.table.span()) any |= table.of(box);
    return any != 0;
}

/// Adds a triangle to the batch; tests and empties the batch when it is full.
HWY_INLINE void add_to_batch(const CellTest& cell, std::uint32_t triangle, const TriangleSlots& box,
    CellKernelMemory& kernel)
{
    CellBatch& batch = kernel.batch;
    batch.triangle[batch.count] = triangle;
    batch.slots[batch.count] = box;
    if (++batch.count == kCellBatch) test_batch(cell, kernel);
}

void test_triangles(const CellTest& cell, const CellWork& work, CellKernelMemory& kernel)
{
    // Boxes are relative to the cell's middle, like the samples' coordinates.
    const float xm = kernel.middle_x, ym = kernel.middle_y;
    const SampleBounds& b = kernel.bounds;
    const BoxSlots slots({b.x0 - xm, b.y0 - ym, b.x1 - xm, b.y1 - ym, b.farthest_w, b.nearest_w});
    fill_groups(cell.samples, slots, kernel);

    for (const ProjectedTriangle& box : work.occluders)
        if (may_hit(box, b)) add_to_batch(cell, box.triangle, {moved(box, xm, ym), slots}, kernel);
    test_batch(cell, kernel);
    std::uint64_t open = 0;
    for (const OverlapTable& table : kernel.table.span()) open |= table.open;
    if (!open) return;

    SlotRegister found;
    for (std::size_t first = 0; first < work.triangles.size(); first += kGroup) {
        const auto some = work.triangles.subspan(
            first, std::min<std::size_t>(kGroup, work.triangles.size() - first));
        for (std::uint32_t rest = find_slots(some, b, {xm, ym}, slots, found); rest;
             rest &= rest - 1) {
            const std::size_t k = std::size_t(std::countr_zero(rest));
            TriangleSlots triangle_slots;
            for (int side = 0; side < 5; ++side)
                triangle_slots.slot[side] = std::uint8_t(found.slot[side][k]);
            if (overlaps_open_group(kernel, triangle_slots))
                add_to_batch(cell, some[k].triangle, triangle_slots, kernel);
        }
    }
    test_batch(cell, kernel);
}

/// test_cell, compiled for one instruction set.
void test_samples(const PencilMesh& mesh, const CellWork& work, const PencilPoints& points,
    CellKernelMemory& kernel, std::uint8_t* shadowed)
{
    const std::span<const IrregularSample> samples = work.samples;
    start_cell(mesh, work.bounds, kernel);
    test_triangles({mesh, samples, points, cell_edge_error(kernel)}, work, kernel);
    for (std::size_t group = 0; group < kernel.shadowed.size(); ++group) {
        const std::size_t first = kernel.first[group], count = kernel.first[group + 1] - first;
        for (std::uint32_t rest = kernel.shadowed[group] & ((1u << count) - 1); rest;
             rest &= rest - 1)
            shadowed[samples[first + std::size_t(std::countr_zero(rest))].id] = 1;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(test_samples);

void reserve(CellKernelMemory& memory, std::size_t samples)
{
    // Rounded up to a power of two, so that slightly larger cells do not allocate again.
    const std::size_t padded = std::bit_ceil(most_groups(samples) * kGroup);
    for (auto* values : {&memory.x, &memory.y, &memory.w}) values->resize(padded);
    memory.item.resize(padded);
    memory.has_item.resize(padded / kGroup);
    memory.shadowed.resize(padded / kGroup);
    memory.first.resize(padded / kGroup + 1);
    memory.table.resize(padded / kGroup / kTableBoxes + 1);
    memory.box.resize(memory.table.size() * kTableBoxes);
}

void test_cell(const PencilMesh& mesh, const CellWork& work, const PencilPoints& points,
    CellKernelMemory& memory, std::span<std::uint8_t> shadowed)
{
    HWY_DYNAMIC_DISPATCH(test_samples)(mesh, work, points, memory, shadowed.data());
}

} // namespace firsthit
#endif
