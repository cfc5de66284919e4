// raster_tile.cpp - the item buffer of one tile: nearest first, hidden blocks skipped, a kernel for
// each size of triangle.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/raster_tile.cpp"
#include "base/simd.h"

#include "visibility/raster_tile.h"
#include "visibility/set_up-inl.h"
#include "visibility/settle.h"

#include <firsthit/scene.h>

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// A register of samples: 16 (a quad of 4x4), 8 (4x2), 4 (4x1), 2 or 1.
using Samples = hn::CappedTag<float, 16>;
/// As many as there are doubles in a register.
using WideSamples = hn::Rebind<float, hn::CappedTag<double, 8>>;

template <class D>
constexpr int columns(D d)
{
    return std::min<int>(4, hn::MaxLanes(d));
}
template <class D>
constexpr int rows(D d)
{
    return std::max<int>(1, int(hn::MaxLanes(d)) / 4);
}

template <class D>
HWY_INLINE std::uint64_t bits(D d, hn::Mask<D> mask)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    return word;
}

/// Sample offsets within a register.
template <class D>
struct LaneOffsets {
    hn::Vec<D> x, y;
    explicit LaneOffsets(D d)
    {
        alignas(64) float lane_x[16], lane_y[16];
        for (int k = 0; k < 16; ++k) {
            lane_x[k] = float(k % columns(d));
            lane_y[k] = float(k / columns(d));
        }
        x = hn::Load(d, lane_x);
        y = hn::Load(d, lane_y);
    }
};

/// A rectangle of a tile's samples, ends included.
struct Box {
    int x0, y0, x1, y1;
};

/// 1/t of a register's samples: float where that is certain, else rounded once from double.
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

/// Triangle i over a box. kCovered: every sample of the box's registers is inside.
template <bool kCovered, bool kWide, class D>
HWY_INLINE void raster_box(D d, const ViewMemory& view, ItemTile& tile, int i, const Box& box)
{
    const Batch& batch = tile.batch;
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
                if (hn::AllFalse(d, maybe)) continue;
                inside = hn::Gt(least, inside_from);
            }
            const int offset = tile.column_offset[x] + tile.row_offset[y];
            float* w_at = tile.w.data() + offset;
            std::uint32_t* item_at = tile.item.data() + offset;
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
                settle_lanes(view, tile, i, {x, y, offset, columns(d)}, bits(d, open),
                    bits(d, inside), w_lanes);
            }
        }
    }
}

HWY_INLINE void mark_stale(ItemTile& tile, const Box& box)
{
    for (int by = box.y0 / kBlock; by <= box.y1 / kBlock; ++by) {
        for (int bx = box.x0 / kBlock; bx <= box.x1 / kBlock; ++bx) {
            const int block = by * tile.blocks_x() + bx;
            tile.stale[block >> 6] |= std::uint64_t(1) << (block & 63);
        }
    }
}

/// Brings block_w and least_w up to date.
HWY_INLINE void refresh_blocks(ItemTile& tile)
{
    const Samples d;
    bool changed = false;
    for (int word = 0; word < 4; ++word) {
        for (std::uint64_t stale = tile.stale[word]; stale; stale &= stale - 1) {
            const int block = word * 64 + std::countr_zero(stale);
            const float* w = tile.w.data() + block * kBlockSamples;
            auto least = hn::Load(d, w);
            for (int k = int(hn::Lanes(d)); k < kBlockSamples; k += int(hn::Lanes(d)))
                least = hn::Min(least, hn::Load(d, w + k));
            tile.block_w[block] = hn::GetLane(hn::MinOfLanes(d, least));
            changed = true;
        }
        tile.stale[word] = 0;
    }
    if (!changed) return;
    float least = tile.block_w[0];
    for (int block = 1; block < tile.blocks(); ++block)
        least = std::min(least, tile.block_w[block]);
    tile.least_w = least;
}

/// Whether all of the triangle is certainly behind what is stored.
HWY_INLINE bool is_hidden(float nearest_w, float stored_w)
{
    return nearest_w * (1 + kDepthSlack) < stored_w;
}

/// Triangle i over its box, whole blocks at first: a row of blocks is tested at once against the
/// edges and against what hides it.
void raster_blocks(const ViewMemory& view, ItemTile& tile, int i)
{
    const hn::CappedTag<float, 8> d;
    const int lanes = int(hn::Lanes(d));
    const Batch& batch = tile.batch;
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
            const auto stored = hn::LoadU(d, tile.block_w + by * tile.blocks_x() + bx);
            const auto hidden = hn::Lt(hn::Mul(block_nearest, hn::Set(d, 1 + kDepthSlack)), stored);
            const auto missed = hn::Lt(best, hn::Set(d, -kBoxError));
            std::uint64_t todo = bits(d, hn::Not(hn::Or(hidden, missed)));
            const std::uint64_t covered = bits(d, hn::Gt(worst, hn::Set(d, kBoxError)));
            const int count = last_bx - bx + 1;
            if (count < lanes) todo &= (std::uint64_t(1) << count) - 1;
            for (; todo; todo &= todo - 1) {
                const int k = std::countr_zero(todo);
                const int x = (bx + k) * kBlock, y = by * kBlock;
                const Box whole{x, y, x + kBlock - 1, y + kBlock - 1};
                const Box part{std::max(x, box.x0), std::max(y, box.y0), std::min(whole.x1, box.x1),
                    std::min(whole.y1, box.y1)};
                if (covered >> k & 1)
                    raster_box<true, false>(Samples(), view, tile, i, whole);
                else
                    raster_box<false, false>(Samples(), view, tile, i, part);
                mark_stale(tile, part);
            }
        }
    }
}

/// Stores the samples that set-up found inside.
HWY_INLINE void store_tiny(const ViewMemory& view, ItemTile& tile, int i)
{
    const Batch& batch = tile.batch;
    for (int k = 0; k < 4; ++k) {
        const float w = batch.tiny_w[k][i];
        if (!(w > 0)) continue;
        const int x = batch.x0[i] + (k & 1), y = batch.y0[i] + (k >> 1);
        const int offset = tile.column_offset[x] + tile.row_offset[y];
        const float stored = tile.w[std::size_t(offset)];
        const float ahead = w - stored, slack = stored * kDepthSlack;
        if (ahead > slack) {
            tile.w[std::size_t(offset)] = w;
            tile.item[std::size_t(offset)] = batch.triangle[i];
        } else if (!(ahead < -slack)) {
            settle_lanes(view, tile, i, {x, y, offset, 1}, 1, 1, &w);
        }
    }
}

void raster_batch(const ViewMemory& view, ItemTile& tile)
{
    Batch& batch = tile.batch;
    const hn::CappedTag<double, 8> d;
    for (int i = 0; i < batch.count; i += int(hn::Lanes(d)))
        set_up_lanes(d, batch, i, tile.x0, tile.y0);
    for (int i = 0; i < batch.count; ++i) {
        const Box box{batch.x0[i], batch.y0[i], batch.x1[i], batch.y1[i]};
        switch (batch.kernel[i]) {
        case Kernel::none:
            continue;
        case Kernel::tiny:
            store_tiny(view, tile, i);
            break;
        case Kernel::small:
            raster_box<false, false>(Samples(), view, tile, i, box);
            break;
        case Kernel::large:
            raster_blocks(view, tile, i);
            continue;
        case Kernel::wide:
            raster_box<false, true>(WideSamples(), view, tile, i, box);
            break;
        case Kernel::exact:
            settle_box(view, tile, i);
            break;
        }
        mark_stale(tile, box);
    }
    batch.count = 0;
}

/// Appends an entry's triangle to the batch.
HWY_INLINE void gather(
    const ViewMemory& view, const TileEntry& entry, float nearest_w, Batch& batch)
{
    const int i = batch.count++;
    batch.triangle[i] = entry.triangle;
    batch.nearest_w[i] = nearest_w;
    const glm::uvec3 index = view.index[entry.triangle];
    for (int k = 0; k < 3; ++k) {
        const glm::vec4& p = view.corner[index[k]];
        batch.corner[3 * k][i] = p.x;
        batch.corner[3 * k + 1][i] = p.y;
        batch.corner[3 * k + 2][i] = p.z;
    }
    // Registers start at multiples of 4 samples, blocks at multiples of 8.
    const bool large = std::max(entry.x1 - entry.x0, entry.y1 - entry.y0) >= 16;
    const int align = large ? 7 : 3;
    batch.x0[i] = entry.x0, batch.y0[i] = entry.y0, batch.x1[i] = entry.x1, batch.y1[i] = entry.y1;
    batch.origin_x[i] = entry.x0 & ~align, batch.origin_y[i] = entry.y0 & ~align;
    batch.extent_x[i] = (entry.x1 | align) - batch.origin_x[i];
    batch.extent_y[i] = (entry.y1 | align) - batch.origin_y[i];
}

/// Nearest first, by classes of 6% of depth, so that triangles of a surface keep their order.
void sort_chunk(std::span<const TileEntry> chunk, ItemTile& tile)
{
    std::uint16_t start[257] = {};
    for (std::size_t k = 0; k < chunk.size(); ++k) {
        const float z = chunk[k].nearest_z;
        // Sign, exponent and four bits of the mantissa grow with z.
        const int depth = z > 0 ? int(std::bit_cast<std::uint32_t>(z) >> 19) - (127 - 8) * 16 : 0;
        tile.chunk_depth[k] = std::uint8_t(std::clamp(depth, 0, 255));
        ++start[tile.chunk_depth[k] + 1];
    }
    for (int depth = 0; depth < 256; ++depth)
        start[depth + 1] = std::uint16_t(start[depth + 1] + start[depth]);
    for (std::size_t k = 0; k < chunk.size(); ++k)
        tile.chunk_order[start[tile.chunk_depth[k]]++] = std::uint16_t(k);
}

/// Whether what is stored hides the entry. Blocks may be out of date: then they hide less.
HWY_INLINE bool entry_hidden(const ItemTile& tile, const TileEntry& entry, float nearest_w)
{
    if (is_hidden(nearest_w, tile.least_w)) return true;
    const int bx0 = entry.x0 / kBlock, bx1 = entry.x1 / kBlock;
    const int by0 = entry.y0 / kBlock, by1 = entry.y1 / kBlock;
    if (bx1 - bx0 > 1 || by1 - by0 > 1) return false;
    const float* row0 = tile.block_w + by0 * tile.blocks_x();
    const float* row1 = tile.block_w + by1 * tile.blocks_x();
    return is_hidden(nearest_w, std::min({row0[bx0], row0[bx1], row1[bx0], row1[bx1]}));
}

/// Asks for the memory of entries that come soon: first their indices, then their corners.
HWY_INLINE void prefetch(
    const ViewMemory& view, std::span<const TileEntry> chunk, const ItemTile& tile, std::size_t n)
{
    constexpr std::size_t kIndices = 24, kCorners = 12; // entries ahead
    if (n + kIndices < chunk.size())
        hwy::Prefetch(&view.index[chunk[tile.chunk_order[n + kIndices]].triangle]);
    if (n + kCorners < chunk.size()) {
        const glm::uvec3& index = view.index[chunk[tile.chunk_order[n + kCorners]].triangle];
        for (int k = 0; k < 3; ++k) hwy::Prefetch(&view.corner[index[k]]);
    }
}

void clear(ItemTile& tile)
{
    const std::size_t samples = std::size_t(tile.size) * std::size_t(tile.size);
    std::fill_n(tile.w.data(), samples, 0.0f);
    std::fill_n(tile.item.data(), samples, kNoItem);
    std::fill_n(tile.block_w, tile.blocks(), 0.0f);
    std::fill_n(tile.stale, 4, std::uint64_t(0));
    tile.least_w = 0;
    tile.coplanar = {};
    tile.counts = {};
}

void raster_entries(const ViewMemory& view, std::span<const TileEntry> entries, ItemTile& tile)
{
    clear(tile);
    for (std::size_t first = 0; first < entries.size(); first += ItemTile::kChunk) {
        const auto chunk =
            entries.subspan(first, std::min(ItemTile::kChunk, entries.size() - first));
        sort_chunk(chunk, tile);
        for (std::size_t n = 0; n < chunk.size(); ++n) {
            prefetch(view, chunk, tile, n);
            const TileEntry& entry = chunk[tile.chunk_order[n]];
            const float z = entry.nearest_z;
            const float nearest_w = z > 0 ? 1 / z : std::numeric_limits<float>::infinity();
            if (entry_hidden(tile, entry, nearest_w)) continue;
            gather(view, entry, nearest_w, tile.batch);
            if (tile.batch.count == kBatch) {
                raster_batch(view, tile);
                refresh_blocks(tile);
            }
        }
    }
    raster_batch(view, tile);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(raster_entries);

void resize(ItemTile& tile, int size)
{
    tile.size = size;
    const std::size_t samples = std::size_t(size) * std::size_t(size);
    tile.w.resize(samples);
    tile.item.resize(samples);
    for (int k = 0; k < size; ++k) {
        tile.column_offset[k] = tile_offset(k, 0, size);
        tile.row_offset[k] = tile_offset(0, k, size);
    }
}

void raster_tile(const ViewMemory& view, int tile, ItemTile& out)
{
    const int tx = tile % view.tiles_x, ty = tile / view.tiles_x;
    out.x0 = float(view.pencil.x0 + tx * view.tile_size);
    out.y0 = float(view.pencil.y0 + ty * view.tile_size);
    const std::uint32_t first = view.tile_start[std::size_t(tile)];
    const std::uint32_t last = view.tile_start[std::size_t(tile) + 1];
    HWY_DYNAMIC_DISPATCH(raster_entries)(view, view.entry.span().subspan(first, last - first), out);
}

} // namespace firsthit
#endif
