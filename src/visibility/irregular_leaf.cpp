// irregular_leaf.cpp - a few thousand samples of the irregular z-buffer against the triangles of
// their cell.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/irregular_leaf.cpp"
#include "base/simd.h"

#include "visibility/irregular_cells.h"
#include "visibility/gather_corners.h"
#include "visibility/irregular_leaf.h"
#include "visibility/irregular_set_up-inl.h"
#include "visibility/sample_registers-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Group = hn::CappedTag<float, kGroup>; // a group is one register or a few

/// Bounds and middle of the cell, and what they say of errors and margins.
void frame_cell(const LightMesh& mesh, std::span<const IrregularSample> samples, double own_margins,
    LeafMemory& leaf)
{
    leaf.count = samples.size();
    leaf.bounds = bounds_of(samples);
    leaf.largest_w = mesh.space.directional ? std::max(std::abs(leaf.bounds.farthest_w),
                                                  std::abs(leaf.bounds.nearest_w))
                                            : std::max(0.0f, leaf.bounds.nearest_w);
    const SampleBounds& b = leaf.bounds;
    const double most_x = std::max(std::abs(b.x0), std::abs(b.x1)),
                 most_y = std::max(std::abs(b.y0), std::abs(b.y1));
    // Floats, so that the offsets are single roundings.
    leaf.middle_x = 0.5f * b.x0 + 0.5f * b.x1;
    leaf.middle_y = 0.5f * b.y0 + 0.5f * b.y1;
    const bool directional = mesh.space.directional;
    leaf.error_x = directional ? 0 : 0x1p-24 * most_x;
    leaf.error_y = directional ? 0 : 0x1p-24 * most_y;
    const auto half = [](double low, double high, double middle, double error) {
        return std::max({high - middle, middle - low, 16 * error, 0x1p-100}) * (1 + 0x1p-20);
    };
    leaf.half_x = half(b.x0, b.x1, leaf.middle_x, leaf.error_x);
    leaf.half_y = half(b.y0, b.y1, leaf.middle_y, leaf.error_y);

    // The margin, over a point's c (see shadow_margin, and irregular_set_up-inl.h).
    const double reach = mesh.space.reach;
    double least = 0, most = 0; // of the largest coordinate, times two, plus reach
    if (directional) {
        const auto away = [](double low, double high) { return std::max({low, -high, 0.0}); };
        const double farthest = b.farthest_w, near = b.nearest_w;
        least = 2 * std::max({away(b.x0, b.x1), away(b.y0, b.y1), away(farthest, near)}) + reach;
        most = 2 * std::max({most_x, most_y, double(leaf.largest_w)}) + reach;
    } else {
        least = 2 + reach * std::max(0.0, double(b.farthest_w));
        most = 2 + reach * double(leaf.largest_w);
    }
    // And of the corners: corner_margin, over c as well.
    const double least_w = directional ? 1 : std::max(0.0, double(b.farthest_w)),
                 most_w = directional ? 1 : double(leaf.largest_w);
    const double low = double(kShadowMargin) * (1 - 0x1p-20),
                 high = double(kShadowMargin) * (1 + 0x1p-20) * own_margins,
                 underflow = kMarginUnderflow * most_w;
    leaf.least_margin = std::max(0.0, low * least - underflow);
    leaf.largest_margin = high * most + own_margins * underflow;
    leaf.least_corner = low * least_w;
    leaf.largest_corner = high * most_w;
}

/// Copies the samples as offsets from the middle, whole groups. What fills up the last group is
/// infinitely near to the light.
void copy_samples(
    std::span<const IrregularSample> samples, const std::uint32_t* item, LeafMemory& leaf)
{
    const Group d;
    const hn::RebindToUnsigned<Group> du;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t padded = (samples.size() + kGroup - 1) / kGroup * kGroup;
    for (auto* values : {&leaf.x, &leaf.y, &leaf.w}) values->resize(padded);
    leaf.item.resize(padded);
    leaf.shadowed.resize(padded / kGroup);
    std::fill_n(leaf.shadowed.data(), padded / kGroup, std::uint16_t(0));
    const auto xm = hn::Set(d, leaf.middle_x), ym = hn::Set(d, leaf.middle_y);
    const auto copy = [&](const IrregularSample* from, std::size_t to) {
        auto x = xm, y = xm, w = xm, id = xm;
        hn::LoadInterleaved4(d, &from->x, x, y, w, id);
        hn::Store(hn::Sub(x, xm), d, leaf.x.data() + to);
        hn::Store(hn::Sub(y, ym), d, leaf.y.data() + to);
        hn::Store(w, d, leaf.w.data() + to);
        hn::Store(hn::BitCast(du, id), du, leaf.item.data() + to);
    };
    std::size_t k = 0;
    for (; k + lanes <= samples.size(); k += lanes) copy(&samples[k], k);
    for (; k < padded; k += lanes) {
        IrregularSample last[kGroup];
        for (std::size_t i = 0; i < lanes; ++i) {
            last[i] = samples[std::min(k + i, samples.size() - 1)];
            if (k + i >= samples.size()) last[i].w = std::numeric_limits<float>::infinity();
        }
        copy(last, k);
    }
    for (std::size_t i = 0; i < padded; ++i) leaf.item[i] = item ? item[leaf.item[i]] : 0xFFFFFFFFu;
}

SampleBounds bounds_of_group(const LeafMemory& leaf, std::size_t group)
{
    const Group d;
    const std::size_t lanes = hn::Lanes(d), first = group * kGroup;
    auto x0 = hn::Load(d, leaf.x.data() + first), x1 = x0;
    auto y0 = hn::Load(d, leaf.y.data() + first), y1 = y0;
    const auto depth = [&](std::size_t k) {
        const auto w = hn::Load(d, leaf.w.data() + k);
        return hn::IfThenElse(hn::Eq(w, w), w, hn::Neg(hn::Inf(d)));
    };
    auto w = depth(first);
    for (std::size_t k = first + lanes; k < first + kGroup; k += lanes) {
        const auto x = hn::Load(d, leaf.x.data() + k), y = hn::Load(d, leaf.y.data() + k);
        x0 = hn::Min(x0, x), x1 = hn::Max(x1, x);
        y0 = hn::Min(y0, y), y1 = hn::Max(y1, y);
        w = hn::Min(w, depth(k));
    }
    const auto least = [&](auto v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto most = [&](auto v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    return {least(x0), least(y0), most(x1), most(y1), least(w), 0};
}

void fill_tables(const BoxSlots& slots, LeafMemory& leaf)
{
    const std::size_t groups = leaf.shadowed.size();
    const std::size_t chunks = (groups + kTableBoxes - 1) / kTableBoxes;
    leaf.table.resize(chunks);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        OverlapTable& table = leaf.table[chunk];
        table = {};
        const std::size_t first = chunk * kTableBoxes, last = std::min(groups, first + kTableBoxes);
        for (std::size_t group = first; group < last; ++group)
            table.add(int(group - first), bounds_of_group(leaf, group), slots);
        table.finish();
    }
}

/// Samples that the filters left open: exactly, one at a time. Returns those that are shadowed.
HWY_NOINLINE std::uint32_t settle_group(const LightMesh& mesh,
    std::span<const IrregularSample> samples, const LightPoints& points, std::uint32_t triangle,
    std::size_t first, std::uint32_t open, LeafMemory& leaf)
{
    const Corners corners = mesh.corners(triangle);
    std::uint32_t shadowed = 0;
    for (; open; open &= open - 1) {
        const std::size_t k = first + std::size_t(std::countr_zero(open));
        if (k >= leaf.count) break;
        ++leaf.counts.uncertain;
        const std::uint32_t id = samples[k].id;
        if (points.lies_on(id, triangle)) continue;
        if (is_shadowed(mesh.space, corners, points.in_light_space(id), leaf.counts.effort))
            shadowed |= open & (~open + 1);
    }
    return shadowed;
}

/// A cell, as the tests of its triangles see it.
struct CellTest {
    const LightMesh& mesh;
    std::span<const IrregularSample> samples;
    const LightPoints& points;
    float edge_error;
};

/// Triangle i of the batch against the given groups of a chunk.
HWY_INLINE void test_groups(
    const CellTest& cell, int i, std::size_t chunk, std::uint64_t groups, LeafMemory& leaf)
{
    const Group d;
    const hn::RebindToUnsigned<Group> du;
    constexpr int lanes = int(hn::MaxLanes(Group()));
    const LeafBatch& batch = leaf.batch;
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
    OverlapTable& table = leaf.table[chunk];

    leaf.counts.pairs += std::uint64_t(std::popcount(groups)) * kGroup;
    for (; groups; groups &= groups - 1) {
        const std::size_t group = chunk * kTableBoxes + std::size_t(std::countr_zero(groups));
        std::uint32_t shadowed = leaf.shadowed[group];
        const std::uint32_t before = shadowed;
        for (int part = 0; part < kGroup; part += lanes) {
            const std::size_t k = group * kGroup + std::size_t(part);
            const auto x = hn::Load(d, leaf.x.data() + k), y = hn::Load(d, leaf.y.data() + k);
            const auto e0 = hn::MulAdd(gx0, x, hn::MulAdd(gy0, y, c0));
            const auto e1 = hn::MulAdd(gx1, x, hn::MulAdd(gy1, y, c1));
            const auto e2 = hn::MulAdd(gx2, x, hn::MulAdd(gy2, y, c2));
            const auto least = hn::Min(e0, hn::Min(e1, e2));
            const auto ahead =
                hn::Sub(hn::MulAdd(wx, x, hn::MulAdd(wy, y, wc)), hn::Load(d, leaf.w.data() + k));
            // Also where `ahead` is no number.
            const auto maybe = hn::AndNot(hn::Lt(ahead, lit_below), hn::Gt(least, maybe_from));
            if (hn::AllFalse(d, maybe)) continue;
            const auto other =
                hn::RebindMask(d, hn::Ne(hn::Load(du, leaf.item.data() + k), triangle));
            const auto certain =
                hn::And(hn::And(hn::Gt(least, inside_from), hn::Gt(ahead, shadowed_from)), other);
            const std::uint32_t hit = std::uint32_t(bits(d, certain)) << part;
            const std::uint32_t open =
                std::uint32_t(bits(d, hn::And(maybe, other))) << part & ~hit & ~shadowed;
            shadowed |= hit;
            if (open) [[unlikely]]
                shadowed |= settle_group(cell.mesh, cell.samples, cell.points, batch.triangle[i],
                    group * kGroup, open, leaf);
        }
        if (shadowed == before) continue;
        leaf.shadowed[group] = std::uint16_t(shadowed);
        if (shadowed == 0xFFFF) table.open &= ~(groups & (~groups + 1));
    }
}

void test_batch(const CellTest& cell, LeafMemory& leaf)
{
    const hn::CappedTag<double, 8> d;
    LeafBatch& batch = leaf.batch;
    gather_corners(cell.mesh, cell.mesh.face, batch.count, batch.triangle, batch.corner);
    for (int i = 0; i < batch.count; i += int(hn::Lanes(d)))
        set_up_leaf_lanes(d, cell.mesh.space.directional, leaf, i);
    for (int i = 0; i < batch.count; ++i) {
        for (std::size_t chunk = 0; chunk < leaf.table.size(); ++chunk) {
            if (const std::uint64_t groups = leaf.table[chunk].of(batch.slots[i]))
                test_groups(cell, i, chunk, groups, leaf);
        }
    }
    leaf.counts.triangles += std::uint64_t(batch.count);
    batch.count = 0;
}

/// The slots of sixteen triangles, a row for each side of the box and the depth.
struct SlotRegister {
    alignas(64) std::int32_t slot[5][kGroup];
};

/// Fills in the slots of up to sixteen triangles. Returns those that may shadow a sample inside the
/// bounds, a bit each.
HWY_INLINE std::uint32_t find_slots(std::span<const SeenTriangle> triangles,
    const SampleBounds& bounds, float xm, float ym, const BoxSlots& slots, SlotRegister& seen)
{
    const Group d;
    const hn::RebindToSigned<Group> w;
    const int lanes = int(hn::Lanes(d));
    constexpr int kStride = int(sizeof(SeenTriangle) / sizeof(float));
    SeenTriangle spare[kGroup];
    const SeenTriangle* from = triangles.data();
    if (triangles.size() < kGroup) {
        for (std::size_t i = 0; i < kGroup; ++i)
            spare[i] = triangles[std::min(i, triangles.size() - 1)];
        from = spare;
    }
    const auto steps = hn::Mul(hn::Iota(w, 0), hn::Set(w, kStride));
    const auto slot_of = [&](auto v, const Slots& axis) { // as Slots::of
        const auto at = hn::Mul(hn::Sub(v, hn::Set(d, axis.start)), hn::Set(d, axis.scale));
        const auto inside = hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), at);
        return hn::ConvertTo(w, hn::Min(inside, hn::Set(d, float(kSlots - 1))));
    };
    std::uint32_t chosen = 0;
    for (int k = 0; k < kGroup; k += lanes) {
        const auto field = [&](const float& first) { return hn::GatherIndex(d, &first, steps); };
        const auto x0 = field(from[k].x0), y0 = field(from[k].y0), x1 = field(from[k].x1),
                   y1 = field(from[k].y1), nearest = field(from[k].nearest_w);
        const auto meets = hn::And(
            hn::And(hn::Le(x0, hn::Set(d, bounds.x1)), hn::Ge(x1, hn::Set(d, bounds.x0))),
            hn::And(hn::And(hn::Le(y0, hn::Set(d, bounds.y1)), hn::Ge(y1, hn::Set(d, bounds.y0))),
                hn::Not(hn::Lt(nearest, hn::Set(d, bounds.farthest_w)))));
        chosen |= std::uint32_t(bits(d, meets)) << k;
        const auto x = hn::Set(d, xm), y = hn::Set(d, ym);
        hn::Store(slot_of(hn::Sub(x0, x), slots.x), w, seen.slot[0] + k);
        hn::Store(slot_of(hn::Sub(y0, y), slots.y), w, seen.slot[1] + k);
        hn::Store(slot_of(hn::Sub(x1, x), slots.x), w, seen.slot[2] + k);
        hn::Store(slot_of(hn::Sub(y1, y), slots.y), w, seen.slot[3] + k);
        hn::Store(slot_of(nearest, slots.w), w, seen.slot[4] + k);
    }
    if (triangles.size() < kGroup) chosen &= (1u << triangles.size()) - 1;
    return chosen;
}

void test_samples(const LightMesh& mesh, std::span<const IrregularSample> samples,
    std::span<const SeenTriangle> triangles, const LightPoints& points, LeafMemory& leaf,
    std::uint8_t* shadowed)
{
    frame_cell(mesh, samples, points.own_margins, leaf);
    copy_samples(samples, points.item, leaf);
    // Boxes as offsets from the middle, like the samples.
    const float xm = leaf.middle_x, ym = leaf.middle_y;
    const SampleBounds& b = leaf.bounds;
    const BoxSlots slots({b.x0 - xm, b.y0 - ym, b.x1 - xm, b.y1 - ym, b.farthest_w, b.nearest_w});
    fill_tables(slots, leaf);

    const CellTest cell{mesh, samples, points, leaf_edge_error(leaf)};
    LeafBatch& batch = leaf.batch;
    SlotRegister seen;
    for (std::size_t first = 0; first < triangles.size(); first += kGroup) {
        const auto some =
            triangles.subspan(first, std::min<std::size_t>(kGroup, triangles.size() - first));
        for (std::uint32_t rest = find_slots(some, b, xm, ym, slots, seen); rest;
             rest &= rest - 1) {
            const std::size_t k = std::size_t(std::countr_zero(rest));
            SeenSlots reach;
            for (int side = 0; side < 5; ++side)
                reach.slot[side] = std::uint8_t(seen.slot[side][k]);
            std::uint64_t any = 0;
            for (const OverlapTable& table : leaf.table.span()) any |= table.of(reach);
            if (!any) continue;
            batch.triangle[batch.count] = some[k].triangle;
            batch.slots[batch.count] = reach;
            if (++batch.count == kLeafBatch) test_batch(cell, leaf);
        }
    }
    test_batch(cell, leaf);

    for (std::size_t group = 0; group < leaf.shadowed.size(); ++group)
        for (std::uint32_t rest = leaf.shadowed[group]; rest; rest &= rest - 1) {
            const std::size_t k = group * kGroup + std::size_t(std::countr_zero(rest));
            shadowed[samples[k].id] = 1;
        }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(test_samples);

void reserve(LeafMemory& memory, std::size_t samples)
{
    const std::size_t padded = std::bit_ceil(samples + kGroup); // seldom more than before
    for (auto* values : {&memory.x, &memory.y, &memory.w}) values->resize(padded);
    memory.item.resize(padded);
    memory.shadowed.resize(padded / kGroup);
    memory.table.resize(padded / kGroup / kTableBoxes + 1);
}

void test_leaf(const LightMesh& mesh, std::span<const IrregularSample> samples,
    std::span<const SeenTriangle> triangles, const LightPoints& points, LeafMemory& memory,
    std::span<std::uint8_t> shadowed)
{
    HWY_DYNAMIC_DISPATCH(test_samples)(mesh, samples, triangles, points, memory, shadowed.data());
}

} // namespace firsthit
#endif
