// leaf_samples-inl.h - the samples of one cell of the irregular z-buffer, made ready for its triangles.
#if defined(FIRSTHIT_LEAF_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_LEAF_SAMPLES_INL_H
#undef FIRSTHIT_LEAF_SAMPLES_INL_H
#else
#define FIRSTHIT_LEAF_SAMPLES_INL_H
#endif

#include <hwy/highway.h>

#include "visibility/irregular_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

using Group = hn::CappedTag<float, kGroup>; // a group is one register or a few

/// Bounds and middle of the cell, and what they say of errors and margins.
inline void frame_cell(const LightMesh& mesh, const SampleBounds& bounds, LeafMemory& leaf)
{
    leaf.bounds = bounds;
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
    const auto away = [](double low, double high) { return std::max({low, -high, 0.0}); };
    const double away_xy = std::max(away(b.x0, b.x1), away(b.y0, b.y1));
    if (directional) {
        const double farthest = b.farthest_w, near = b.nearest_w;
        least = 2 * std::max(away_xy, away(farthest, near)) + reach;
        most = 2 * std::max({most_x, most_y, double(leaf.largest_w)}) + reach;
    } else {
        least = 2 * std::max(1.0, away_xy) + reach * std::max(0.0, double(b.farthest_w));
        most = 2 * std::max({1.0, most_x, most_y}) + reach * double(leaf.largest_w);
    }
    // And of the corners: corner_margin, over c as well.
    const double least_w = directional ? 1 : std::max(0.0, double(b.farthest_w)),
                 most_w = directional ? 1 : double(leaf.largest_w);
    const double underflow = kMarginUnderflow * most_w;
    leaf.least_margin = std::max(0.0, double(kShadowMargin) * least * (1 - 0x1p-20) - underflow);
    leaf.largest_margin = double(kShadowMargin) * most * (1 + 0x1p-20) + underflow;
    leaf.least_corner = double(kShadowMargin) * least_w * (1 - 0x1p-20);
    leaf.largest_corner = double(kShadowMargin) * most_w * (1 + 0x1p-20);
}

/// Copies the samples as offsets from the middle, whole groups. What fills up the last group is
/// infinitely near to the light.
inline void copy_samples(std::span<const IrregularSample> samples, LeafMemory& leaf)
{
    const Group d;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t padded = (samples.size() + kGroup - 1) / kGroup * kGroup;
    for (auto* values : {&leaf.x, &leaf.y, &leaf.w}) values->resize(padded);
    leaf.item.resize(padded);
    leaf.has_item.resize(padded / kGroup);
    leaf.shadowed.resize(padded / kGroup);
    std::fill_n(leaf.shadowed.data(), padded / kGroup, std::uint16_t(0));
    const auto xm = hn::Set(d, leaf.middle_x), ym = hn::Set(d, leaf.middle_y);
    const auto copy = [&](const IrregularSample* from, std::size_t to) {
        auto x = xm, y = xm, w = xm, id = xm;
        hn::LoadInterleaved4(d, &from->x, x, y, w, id);
        hn::Store(hn::Sub(x, xm), d, leaf.x.data() + to);
        hn::Store(hn::Sub(y, ym), d, leaf.y.data() + to);
        hn::Store(w, d, leaf.w.data() + to);
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
    std::fill_n(leaf.has_item.data(), padded / kGroup, std::uint8_t(0));
}

inline SampleBounds bounds_of_group(const LeafMemory& leaf, std::size_t group)
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

inline void fill_tables(const BoxSlots& slots, LeafMemory& leaf)
{
    const std::size_t groups = leaf.shadowed.size();
    const std::size_t chunks = (groups + kTableBoxes - 1) / kTableBoxes;
    leaf.table.resize(chunks);
    for (auto* values : {&leaf.group_x, &leaf.group_y, &leaf.reach_x, &leaf.reach_y})
        values->resize(chunks * kTableBoxes);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        OverlapTable& table = leaf.table[chunk];
        table = {};
        const std::size_t first = chunk * kTableBoxes, last = std::min(groups, first + kTableBoxes);
        for (std::size_t group = first; group < last; ++group) {
            const SampleBounds box = bounds_of_group(leaf, group);
            table.add(int(group - first), box, slots);
            const float x = 0.5f * (box.x0 + box.x1), y = 0.5f * (box.y0 + box.y1);
            leaf.group_x[group] = x;
            leaf.group_y[group] = y;
            leaf.reach_x[group] = std::max(box.x1 - x, x - box.x0) * (1 + 0x1p-20f);
            leaf.reach_y[group] = std::max(box.y1 - y, y - box.y0) * (1 + 0x1p-20f);
        }
        table.finish();
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
