// raster_kernels-inl.h - the kernels that rasterise a triangle of the batch over the samples of a
// tile.
#if defined(FIRSTHIT_RASTER_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_RASTER_KERNELS_INL_H
#undef FIRSTHIT_RASTER_KERNELS_INL_H
#else
#define FIRSTHIT_RASTER_KERNELS_INL_H
#endif

#include "visibility/raster/sample_registers-inl.h"
#include "visibility/raster/set_up-inl.h"
#include "visibility/raster/decide_exactly.h"

#include <algorithm>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// A rectangle of a tile's samples; x1 and y1 are inside.
struct Box {
    int x0, y0, x1, y1;
};

/// 1/t of triangle i at the samples of a register: computed in float, or if kWide in double and
/// rounded once.
///
/// x, y  offsets from the batch's (origin_x, origin_y)
template <bool kWide, class D>
HWY_INLINE hn::Vec<D> inverse_depth(D d, const Batch& batch, int i, hn::Vec<D> x, hn::Vec<D> y)
{
    if constexpr (kWide) {
        const hn::Rebind<double, D> wide;
        const auto wx = hn::Mul(hn::Set(wide, batch.wide_wx[i]), hn::PromoteTo(wide, x));
        const auto wy = hn::Mul(hn::Set(wide, batch.wide_wy[i]), hn::PromoteTo(wide, y));
        return hn::DemoteTo(d, hn::Add(hn::Add(wx, wy), hn::Set(wide, batch.wide_wc[i])));
    } else {
        return hn::MulAdd(hn::Set(d, batch.wx[i]), x,
            hn::MulAdd(hn::Set(d, batch.wy[i]), y, hn::Set(d, batch.wc[i])));
    }
}

/// Rasterises triangle i over a box.
///
/// kCovered  the triangle covers every sample of the box's registers
/// kWide     depth is computed in double
template <bool kCovered, bool kWide, class D>
HWY_INLINE void raster_box(D d, const TileInWork& tile, int i, const Box& box)
{
    TileItems& items = tile.items;
    RasterScratch& scratch = tile.scratch;
    const Batch& batch = scratch.batch;
    const hn::RebindToUnsigned<D> du;
    const LaneOffsets<D> lane(d);
    const auto gx0 = hn::Set(d, batch.gx[0][i]), gx1 = hn::Set(d, batch.gx[1][i]),
               gx2 = hn::Set(d, batch.gx[2][i]);
    const auto inside_from = hn::Set(d, kEdgeError), maybe_from = hn::Set(d, -kEdgeError);
    const auto slack_factor = hn::Set(d, kDepthSlack);
    const auto id = hn::Set(du, batch.triangle[i]);
    const int first_x = box.x0 & -columns(d), first_y = box.y0 & -rows(d);

    for (int y = first_y; y <= box.y1; y += rows(d)) {
        const auto py = hn::Add(hn::Set(d, float(y - batch.origin_y[i])), lane.y);
        const auto row = [&](int k) {
            return hn::MulAdd(hn::Set(d, batch.gy[k][i]), py, hn::Set(d, batch.c[k][i]));
        };
        const auto r0 = row(0), r1 = row(1), r2 = row(2);
        for (int x = first_x; x <= box.x1; x += columns(d)) {
            const auto px = hn::Add(hn::Set(d, float(x - batch.origin_x[i])), lane.x);
            auto inside = hn::Eq(px, px), maybe = inside;
            if constexpr (!kCovered) {
                const auto least = hn::Min(hn::MulAdd(gx0, px, r0),
                    hn::Min(hn::MulAdd(gx1, px, r1), hn::MulAdd(gx2, px, r2)));
                maybe = hn::Gt(least, maybe_from);
                if constexpr (kWide)
                    if (hn::AllFalse(d, maybe)) continue;
                inside = hn::Gt(least, inside_from);
            }
            const int offset = scratch.column_offset[x] + scratch.row_offset[y];
            float* w_at = scratch.w.data() + offset;
            std::uint32_t* item_at = items.item.data() + offset;
            const auto w = inverse_depth<kWide>(d, batch, i, px, py);
            const auto stored = hn::Load(d, w_at);
            const auto ahead = hn::Sub(w, stored);
            const auto slack = hn::Mul(stored, slack_factor);
            const auto win = hn::And(inside, hn::Gt(ahead, slack));
            const auto open = hn::AndNot(hn::Or(win, hn::Lt(ahead, hn::Neg(slack))), maybe);
            hn::Store(hn::IfThenElse(win, w, stored), d, w_at);
            hn::Store(
                hn::IfThenElse(hn::RebindMask(du, win), id, hn::Load(du, item_at)), du, item_at);
            if (!hn::AllFalse(d, open)) [[unlikely]] {
                alignas(64) float w_lanes[16];
                hn::Store(w, d, w_lanes);
                decide_lanes_exactly(
                    tile, i, {x, y, offset, columns(d), bits(d, open), bits(d, inside), w_lanes});
            }
        }
    }
}

/// Rasterises triangle i, a cut-out, over a box: as raster_box, but each sample that it may hit in
/// front of what is stored is decided on its own, with its opacity.
template <bool kWide, class D>
HWY_INLINE void raster_cutout(D d, const TileInWork& tile, int i, const Box& box)
{
    const RasterScratch& scratch = tile.scratch;
    const Batch& batch = scratch.batch;
    const LaneOffsets<D> lane(d);
    const auto inside_from = hn::Set(d, kEdgeError), maybe_from = hn::Set(d, -kEdgeError);
    const int first_x = box.x0 & -columns(d), first_y = box.y0 & -rows(d);
    for (int y = first_y; y <= box.y1; y += rows(d)) {
        const auto py = hn::Add(hn::Set(d, float(y - batch.origin_y[i])), lane.y);
        for (int x = first_x; x <= box.x1; x += columns(d)) {
            const auto px = hn::Add(hn::Set(d, float(x - batch.origin_x[i])), lane.x);
            const auto edge = [&](int e) {
                return hn::MulAdd(hn::Set(d, batch.gx[e][i]), px,
                    hn::MulAdd(hn::Set(d, batch.gy[e][i]), py, hn::Set(d, batch.c[e][i])));
            };
            const auto least = hn::Min(edge(0), hn::Min(edge(1), edge(2)));
            const int offset = scratch.column_offset[x] + scratch.row_offset[y];
            const auto w = inverse_depth<kWide>(d, batch, i, px, py);
            const auto stored = hn::Load(d, scratch.w.data() + offset);
            const auto behind =
                hn::Lt(hn::Sub(w, stored), hn::Neg(hn::Mul(stored, hn::Set(d, kDepthSlack))));
            const auto open = hn::AndNot(behind, hn::Gt(least, maybe_from));
            if (hn::AllFalse(d, open)) continue;
            alignas(64) float w_lanes[16];
            hn::Store(w, d, w_lanes);
            decide_lanes_exactly(tile, i,
                {x, y, offset, columns(d), bits(d, open), bits(d, hn::Gt(least, inside_from)),
                    w_lanes});
        }
    }
}

/// Rasterises triangle i over all samples of the block in column bx and row by. Does what
/// raster_box does, but without branches that depend on the box or on single registers. The
/// triangle's extent in the batch has to include whole blocks.
template <bool kCovered>
HWY_INLINE void raster_block(const TileInWork& tile, int i, int bx, int by)
{
    const Samples d;
    const Batch& batch = tile.scratch.batch;
    const hn::RebindToUnsigned<Samples> du;
    constexpr int kColumns = columns(Samples()), kRows = rows(Samples());
    constexpr int kRegisters = kBlockSamples / (kColumns * kRows);
    const LaneOffsets<Samples> lane(d);
    const int block = by * tile.items.blocks_x() + bx;
    const float x0 = float(bx * kBlock - batch.origin_x[i]);
    const float y0 = float(by * kBlock - batch.origin_y[i]);
    const auto inside_from = hn::Set(d, kEdgeError), maybe_from = hn::Set(d, -kEdgeError);
    const auto slack_factor = hn::Set(d, kDepthSlack);
    const auto id = hn::Set(du, batch.triangle[i]);
    float* const stored_w = tile.scratch.w.data() + block * kBlockSamples;
    std::uint32_t* const stored_item = tile.items.item.data() + block * kBlockSamples;
    hn::Mask<Samples> open[kRegisters], sure[kRegisters];
    auto any_open = hn::Ne(inside_from, inside_from); // none
    HWY_UNROLL(4)
    for (int k = 0; k < kRegisters; ++k) {
        const int at = k * kColumns * kRows;
        const auto px = hn::Add(hn::Set(d, x0 + float(block_x(at))), lane.x);
        const auto py = hn::Add(hn::Set(d, y0 + float(block_y(at))), lane.y);
        const auto edge = [&](int e) {
            return hn::MulAdd(hn::Set(d, batch.gx[e][i]), px,
                hn::MulAdd(hn::Set(d, batch.gy[e][i]), py, hn::Set(d, batch.c[e][i])));
        };
        auto inside = hn::Eq(px, px), maybe = inside;
        if constexpr (!kCovered) {
            const auto least = hn::Min(edge(0), hn::Min(edge(1), edge(2)));
            maybe = hn::Gt(least, maybe_from);
            inside = hn::Gt(least, inside_from);
        }
        const auto w = inverse_depth<false>(d, batch, i, px, py);
        const auto stored = hn::Load(d, stored_w + at);
        const auto ahead = hn::Sub(w, stored), slack = hn::Mul(stored, slack_factor);
        const auto win = hn::And(inside, hn::Gt(ahead, slack));
        sure[k] = inside;
        open[k] = hn::AndNot(hn::Or(win, hn::Lt(ahead, hn::Neg(slack))), maybe);
        any_open = hn::Or(any_open, open[k]);
        hn::BlendedStore(w, win, d, stored_w + at);
        hn::BlendedStore(id, hn::RebindMask(du, win), du, stored_item + at);
    }
    if (hn::AllFalse(d, any_open)) [[likely]]
        return;
    for (int k = 0; k < kRegisters; ++k) {
        if (hn::AllFalse(d, open[k])) continue;
        const int at = k * kColumns * kRows;
        const int dx = block_x(at), dy = block_y(at);
        const auto px = hn::Add(hn::Set(d, x0 + float(dx)), lane.x);
        const auto py = hn::Add(hn::Set(d, y0 + float(dy)), lane.y);
        alignas(64) float w_lanes[16];
        hn::Store(inverse_depth<false>(d, batch, i, px, py), d, w_lanes);
        decide_lanes_exactly(tile, i,
            {bx * kBlock + dx, by * kBlock + dy, block * kBlockSamples + at, kColumns,
                bits(d, open[k]), bits(d, sure[k]), w_lanes});
    }
}

/// Notes that block_w of a block may have become too small.
HWY_INLINE void mark_stale(RasterScratch& scratch, int block)
{
    scratch.stale[block >> 6] |= std::uint64_t(1) << (block & 63);
}

/// The same for all blocks that a box meets.
HWY_INLINE void mark_stale(const TileInWork& tile, const Box& box)
{
    for (int by = box.y0 / kBlock; by <= box.y1 / kBlock; ++by)
        for (int bx = box.x0 / kBlock; bx <= box.x1 / kBlock; ++bx)
            mark_stale(tile.scratch, by * tile.items.blocks_x() + bx);
}

/// Updates block_w of the stale blocks, and least_w.
///
/// blocks  number of blocks of the tile
HWY_INLINE void refresh_blocks(RasterScratch& scratch, int blocks)
{
    const Samples d;
    bool changed = false;
    for (int word = 0; word < 4; ++word) {
        for (std::uint64_t stale = scratch.stale[word]; stale; stale &= stale - 1) {
            const int block = word * 64 + std::countr_zero(stale);
            const float* w = scratch.w.data() + block * kBlockSamples;
            auto least = hn::Load(d, w);
            for (int k = int(hn::Lanes(d)); k < kBlockSamples; k += int(hn::Lanes(d)))
                least = hn::Min(least, hn::Load(d, w + k));
            scratch.block_w[block] = hn::GetLane(hn::MinOfLanes(d, least));
            changed = true;
        }
        scratch.stale[word] = 0;
    }
    if (!changed) return;
    auto least = hn::Set(d, scratch.block_w[0]);
    int block = 0;
    for (; block + int(hn::Lanes(d)) <= blocks; block += int(hn::Lanes(d)))
        least = hn::Min(least, hn::Load(d, scratch.block_w + block));
    scratch.least_w = hn::GetLane(hn::MinOfLanes(d, least));
    for (; block < blocks; ++block)
        scratch.least_w = std::min(scratch.least_w, scratch.block_w[block]);
}

/// Whether a triangle is certainly behind all stored triangles of a part of the tile.
///
/// nearest_w  at least the triangle's 1/t
/// stored_w   at most the stored 1/t
HWY_INLINE bool is_hidden(float nearest_w, float stored_w)
{
    return nearest_w * (1 + kDepthSlack) < stored_w;
}

/// Rasterises triangle i over the blocks that its box meets. Tests up to eight blocks of a row at a
/// time against the edges and the stored depths, and skips the blocks that it misses or that hide
/// it.
inline void raster_blocks(const TileInWork& tile, int i)
{
    const hn::CappedTag<float, 8> d;
    const int lanes = int(hn::Lanes(d)), blocks_x = tile.items.blocks_x();
    const Batch& batch = tile.scratch.batch;
    const Box box{batch.x0[i], batch.y0[i], batch.x1[i], batch.y1[i]};
    alignas(64) float numbers[8];
    for (int k = 0; k < 8; ++k) numbers[k] = float(k * kBlock);
    const auto block_step = hn::Load(d, numbers);
    const auto zero = hn::Zero(d), reach = hn::Set(d, float(kBlock - 1));
    const auto nearest_w = hn::Set(d, batch.nearest_w[i]);

    for (int by = box.y0 / kBlock; by <= box.y1 / kBlock; ++by) {
        const auto py = hn::Set(d, float(by * kBlock - batch.origin_y[i]));
        const int last_bx = box.x1 / kBlock;
        for (int bx = box.x0 / kBlock; bx <= last_bx; bx += lanes) {
            const auto px = hn::Add(hn::Set(d, float(bx * kBlock - batch.origin_x[i])), block_step);
            auto best = hn::Set(d, 1.0f), worst = best;
            for (int k = 0; k < 3; ++k) {
                const auto gx = hn::Set(d, batch.gx[k][i]), gy = hn::Set(d, batch.gy[k][i]);
                const auto e = hn::MulAdd(gx, px, hn::MulAdd(gy, py, hn::Set(d, batch.c[k][i])));
                const auto up = hn::Add(hn::Max(gx, zero), hn::Max(gy, zero));
                const auto down = hn::Add(hn::Min(gx, zero), hn::Min(gy, zero));
                best = hn::Min(best, hn::MulAdd(up, reach, e));
                worst = hn::Min(worst, hn::MulAdd(down, reach, e));
            }
            const auto wx = hn::Set(d, batch.wx[i]), wy = hn::Set(d, batch.wy[i]);
            const auto w = hn::MulAdd(wx, px, hn::MulAdd(wy, py, hn::Set(d, batch.wc[i])));
            const auto w_up = hn::Add(hn::Max(wx, zero), hn::Max(wy, zero));
            const auto block_nearest = hn::Min(nearest_w, hn::MulAdd(w_up, reach, w));
            const auto stored = hn::LoadU(d, tile.scratch.block_w + by * blocks_x + bx);
            const auto hidden = hn::Lt(hn::Mul(block_nearest, hn::Set(d, 1 + kDepthSlack)), stored);
            const auto missed = hn::Lt(best, hn::Set(d, -kBoxError));
            std::uint64_t todo = bits(d, hn::Not(hn::Or(hidden, missed)));
            const std::uint64_t covered = bits(d, hn::Gt(worst, hn::Set(d, kBoxError)));
            const int count = last_bx - bx + 1;
            if (count < lanes) todo &= (std::uint64_t(1) << count) - 1;
            for (; todo; todo &= todo - 1) {
                const int k = std::countr_zero(todo);
                if (covered >> k & 1)
                    raster_block<true>(tile, i, bx + k, by);
                else
                    raster_block<false>(tile, i, bx + k, by);
                mark_stale(tile.scratch, by * blocks_x + bx + k);
            }
        }
    }
}

/// Stores a triangle of Kernel::tiny at the samples that the set-up found inside.
HWY_INLINE void store_tiny(const TileInWork& tile, int i)
{
    RasterScratch& scratch = tile.scratch;
    const Batch& batch = scratch.batch;
    for (int k = 0; k < 4; ++k) {
        const float w = batch.tiny_w[k][i];
        if (!(w > 0)) continue;
        const int x = batch.x0[i] + (k & 1), y = batch.y0[i] + (k >> 1);
        const int offset = scratch.column_offset[x] + scratch.row_offset[y];
        const float stored = scratch.w[std::size_t(offset)];
        const float ahead = w - stored, slack = stored * kDepthSlack;
        if (ahead > slack) {
            scratch.w[std::size_t(offset)] = w;
            tile.items.item[std::size_t(offset)] = batch.triangle[i];
        } else if (!(ahead < -slack)) {
            decide_lanes_exactly(tile, i, {x, y, offset, 1, 1, 1, &w});
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
