// cell_samples-inl.h - copies the samples of one cell of the irregular z-buffer into groups, and
// computes the cell's frame and error bounds.
#if defined(FIRSTHIT_IRREGULAR_CELLS_CELL_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_CELLS_CELL_SAMPLES_INL_H_
#undef FIRSTHIT_IRREGULAR_CELLS_CELL_SAMPLES_INL_H_
#else
#define FIRSTHIT_IRREGULAR_CELLS_CELL_SAMPLES_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/cells/cell_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Group = hn::CappedTag<float, kGroup>; // a group takes one register or a few

/// Sets bounds, middle, error and margin bounds of the cell.
inline void start_cell(const PencilMesh& mesh, const SampleBounds& bounds, CellKernelMemory& kernel)
{
    kernel.bounds = bounds;
    kernel.largest_w = mesh.space.directional ? std::max(std::abs(kernel.bounds.farthest_w),
                                                    std::abs(kernel.bounds.nearest_w))
                                              : std::max(0.0f, kernel.bounds.nearest_w);
    const SampleBounds& b = kernel.bounds;
    const double most_x = std::max(std::abs(b.x0), std::abs(b.x1)),
                 most_y = std::max(std::abs(b.y0), std::abs(b.y1));
    // The middle is a float, so that the offsets of samples are rounded once.
    kernel.middle_x = 0.5f * b.x0 + 0.5f * b.x1;
    kernel.middle_y = 0.5f * b.y0 + 0.5f * b.y1;
    const bool directional = mesh.space.directional;
    kernel.error_x = directional ? 0 : 0x1p-24 * most_x;
    kernel.error_y = directional ? 0 : 0x1p-24 * most_y;
    const auto half = [](double low, double high, double middle, double error) {
        return std::max({high - middle, middle - low, 16 * error, 0x1p-100}) * (1 + 0x1p-20);
    };
    kernel.half_x = half(b.x0, b.x1, kernel.middle_x, kernel.error_x);
    kernel.half_y = half(b.y0, b.y1, kernel.middle_y, kernel.error_y);

    // Bounds of shadow_margin over c (see set_up-inl.h).
    const double reach = mesh.space.reach;
    double least = 0, most = 0; // of 2 * (largest coordinate) + reach, over c
    const auto away = [](double low, double high) { return std::max({low, -high, 0.0}); };
    const double away_xy = std::max(away(b.x0, b.x1), away(b.y0, b.y1));
    if (directional) {
        const double farthest = b.farthest_w, near = b.nearest_w;
        least = 2 * std::max(away_xy, away(farthest, near)) + reach;
        most = 2 * std::max({most_x, most_y, double(kernel.largest_w)}) + reach;
    } else {
        least = 2 * std::max(1.0, away_xy) + reach * std::max(0.0, double(b.farthest_w));
        most = 2 * std::max({1.0, most_x, most_y}) + reach * double(kernel.largest_w);
    }
    // Bounds of corner_margin over c, for a corner whose largest coordinate is 1.
    const double least_w = directional ? 1 : std::max(0.0, double(b.farthest_w)),
                 most_w = directional ? 1 : double(kernel.largest_w);
    const double underflow = kMarginUnderflow * most_w;
    kernel.least_margin = std::max(0.0, double(kShadowMargin) * least * (1 - 0x1p-20) - underflow);
    kernel.largest_margin = double(kShadowMargin) * most * (1 + 0x1p-20) + underflow;
    kernel.least_corner = double(kShadowMargin) * least_w * (1 - 0x1p-20);
    kernel.largest_corner = double(kShadowMargin) * most_w * (1 + 0x1p-20);
}

/// How many of the next sixteen samples make a group. Reads seventeen samples. The 4x4 samples of
/// one square of pixels have consecutive ids (base/tile_order.h), and the group ends before a
/// square that would not fit into it wholly. For ids that do not rise, the result is any number
/// from 1 to 16; every number is correct, but some give more groups or larger boxes.
HWY_INLINE std::size_t group_size(const IrregularSample* samples)
{
    const auto square = [&](std::size_t k) { return samples[k].id / kGroup; };
    const std::uint32_t last = square(kGroup - 1);
    if (samples[kGroup - 1].id - samples[0].id == kGroup - 1 && samples[0].id % kGroup == 0)
        return kGroup; // a whole square
    if (square(kGroup) != last || square(0) == last) return kGroup;
    std::size_t before = 0; // index of the last sample that is not of the last square
    for (std::size_t step = kGroup / 2; step > 0; step /= 2)
        before += square(before + step) != last ? step : 0;
    return before + 1;
}

/// The bounds of a group's samples, lane by lane. A w of NaN counts as infinitely far.
struct GroupBounds {
    using V = hn::Vec<Group>;
    V x, minus_x, y, minus_y, w; // the minimum of each

    HWY_INLINE void add(const V& sample_x, const V& sample_y, const V& sample_w)
    {
        x = hn::Min(x, sample_x), minus_x = hn::Min(minus_x, hn::Neg(sample_x));
        y = hn::Min(y, sample_y), minus_y = hn::Min(minus_y, hn::Neg(sample_y));
        const auto depth =
            hn::IfThenElse(hn::Eq(sample_w, sample_w), sample_w, hn::Neg(hn::Inf(Group())));
        w = hn::Min(w, depth);
    }
};

#if HWY_TARGET != HWY_SCALAR
/// The minimum over the register's blocks of four lanes: element k of the result is the minimum of
/// lanes k, k + 4, k + 8, ...
template <class D>
HWY_INLINE auto least_of_blocks(D, hn::Vec<D> v)
{
    if constexpr (hn::MaxLanes(D()) <= 4) {
        return v;
    } else {
        const hn::Half<D> half;
        return least_of_blocks(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
    }
}
#endif

/// Stores the minimum of x, -x, y and -y over all lanes; see GroupBox.
HWY_INLINE void store_box(const GroupBounds& bounds, float* box)
{
#if HWY_TARGET == HWY_SCALAR
    box[0] = hn::GetLane(bounds.x), box[1] = hn::GetLane(bounds.minus_x);
    box[2] = hn::GetLane(bounds.y), box[3] = hn::GetLane(bounds.minus_y);
#else
    const Group d;
    const hn::Repartition<std::uint64_t, Group> pairs;
    const auto fold = [&](auto a, auto b) {
        return hn::Min(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b));
    };
    const auto xs = hn::BitCast(pairs, fold(bounds.x, bounds.minus_x)),
               ys = hn::BitCast(pairs, fold(bounds.y, bounds.minus_y));
    const auto fours = hn::Min(hn::BitCast(d, hn::InterleaveLower(pairs, xs, ys)),
        hn::BitCast(d, hn::InterleaveUpper(pairs, xs, ys)));
    hn::StoreU(least_of_blocks(d, fours), hn::CappedTag<float, 4>(), box);
#endif
}

/// Finds the slots of groups' boxes. The result is that of Slots::of, but without branches, which
/// would be mispredicted.
class GroupSlots {
  public:
    static constexpr int kSides = 4;

    explicit GroupSlots(const BoxSlots& slots) : slots_(slots)
    {
        const Slots* axis[kSides] = {&slots.x, &slots.x, &slots.y, &slots.y};
        for (int k = 0; k < kSides; ++k) {
            start_[k] = axis[k]->start;
            scale_[k] = axis[k]->scale;
        }
    }

    /// box       see GroupBox
    /// farthest  the smallest w of the group's samples
    /// slot      out: of x0, x1, y0, y1 and the farthest w
    HWY_INLINE void find(const float* box, float farthest, int (&slot)[kSides + 1]) const
    {
#if HWY_TARGET == HWY_SCALAR
        slot[0] = slots_.x.of(box[0]), slot[1] = slots_.x.of(-box[1]);
        slot[2] = slots_.y.of(box[2]), slot[3] = slots_.y.of(-box[3]);
        slot[4] = slots_.w.of(farthest);
#else
        const hn::FixedTag<float, kSides> d;
        const hn::RebindToSigned<decltype(d)> w;
        const auto slot_of = [&](auto v, auto start, auto scale) {
            const auto at = hn::Mul(hn::Sub(v, start), scale);
            const auto inside = hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), at);
            return hn::ConvertTo(w, hn::Min(inside, hn::Set(d, float(kSlots - 1))));
        };
        alignas(16) static constexpr float kSign[kSides] = {0.0f, -0.0f, 0.0f, -0.0f};
        const auto sides = hn::Xor(hn::LoadU(d, box), hn::Load(d, kSign));
        hn::StoreU(slot_of(sides, hn::Load(d, start_), hn::Load(d, scale_)), w, slot);
        slot[kSides] = hn::GetLane(
            slot_of(hn::Set(d, farthest), hn::Set(d, slots_.w.start), hn::Set(d, slots_.w.scale)));
#endif
    }

  private:
    BoxSlots slots_;
    alignas(16) float start_[kSides], scale_[kSides];
};

/// Copies `count` samples to a group, as offsets from the middle. The lanes after them get the
/// position of the first sample and an infinite w, which no triangle shadows.
/// from  kGroup samples are read
HWY_INLINE GroupBounds copy_group(
    const IrregularSample* from, std::size_t count, std::size_t group, CellKernelMemory& kernel)
{
    const Group d;
    const auto infinite = hn::Inf(d);
    const auto xm = hn::Set(d, kernel.middle_x), ym = hn::Set(d, kernel.middle_y);
    GroupBounds bounds{infinite, infinite, infinite, infinite, infinite};
    for (std::size_t offset = 0; offset < kGroup; offset += hn::Lanes(d)) {
        auto x = xm, y = xm, w = xm, id = xm;
        hn::LoadInterleaved4(d, &from[offset].x, x, y, w, id);
        const auto inside = hn::FirstN(d, count > offset ? count - offset : 0);
        x = hn::Sub(hn::IfThenElse(inside, x, hn::Set(d, from->x)), xm);
        y = hn::Sub(hn::IfThenElse(inside, y, hn::Set(d, from->y)), ym);
        w = hn::IfThenElse(inside, w, infinite);
        bounds.add(x, y, w);
        const std::size_t to = group * kGroup + offset;
        hn::Store(x, d, kernel.x.data() + to);
        hn::Store(y, d, kernel.y.data() + to);
        hn::Store(w, d, kernel.w.data() + to);
    }
    return bounds;
}

/// Copies all samples of the cell into groups, and enters the groups into the overlap tables.
/// slots  made from bounds that are relative to the cell's middle
inline void fill_groups(
    std::span<const IrregularSample> samples, const BoxSlots& slots, CellKernelMemory& kernel)
{
    constexpr std::size_t kAhead = 8 * kGroup; // samples: how far ahead memory is prefetched
    const std::size_t most = most_groups(samples.size());
    for (auto* values : {&kernel.x, &kernel.y, &kernel.w}) values->resize(most * kGroup);
    kernel.first.resize(most + 1);
    kernel.shadowed.resize(most);
    const std::size_t most_tables = (most + kTableBoxes - 1) / kTableBoxes;
    kernel.table.resize(most_tables);
    kernel.box.resize(most_tables * kTableBoxes);
    const GroupSlots group_slots(slots);
    std::size_t group = 0, previous = kGroup; // previous: the size of the group before this one
    for (std::size_t k = 0; k < samples.size(); ++group) {
        const IrregularSample* from = &samples[k];
        const std::size_t left = samples.size() - k;
        if (left > kAhead + kGroup)
            for (std::size_t line = 0; line < kGroup; line += 4)
                __builtin_prefetch(from + kAhead + line);
        std::size_t count = left > kGroup ? group_size(from) : left;
        // Ids that do not rise could make more groups than most_groups allows.
        if (left > kGroup && previous + count <= kGroup) count = kGroup;
        previous = count;
        IrregularSample last[kGroup];
        if (left < kGroup) {
            std::copy_n(from, left, last);
            std::fill_n(last + left, kGroup - left, last[0]);
            from = last;
        }
        const GroupBounds bounds = copy_group(from, count, group, kernel);
        float* box = kernel.box[group].side;
        store_box(bounds, box);
        const float farthest = hn::GetLane(hn::MinOfLanes(Group(), bounds.w));
        OverlapTable& table = kernel.table[group / kTableBoxes];
        if (group % kTableBoxes == 0) table = {};
        int slot[GroupSlots::kSides + 1];
        group_slots.find(box, farthest, slot);
        table.add(int(group % kTableBoxes), slot);
        kernel.first[group] = std::uint32_t(k);
        kernel.shadowed[group] = std::uint16_t(0xFFFFu << count);
        k += count;
    }
    kernel.first[group] = std::uint32_t(samples.size());
    kernel.shadowed.resize(group);
    kernel.item.resize(group * kGroup);
    kernel.has_item.resize(group);
    std::fill_n(kernel.has_item.data(), group, std::uint8_t(0));
    kernel.table.resize((group + kTableBoxes - 1) / kTableBoxes);
    for (OverlapTable& table : kernel.table.span()) table.finish();
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
