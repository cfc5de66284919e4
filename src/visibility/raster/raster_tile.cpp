// raster_tile.cpp - rasterises the item buffer of one tile. Triangles are sorted nearest first, so
// that hidden ones can be skipped, and are rasterised by a kernel for their size.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/raster/raster_tile.cpp"
#include "base/simd.h"

#include "visibility/raster/raster_tile.h"
#include "visibility/raster/raster_kernels-inl.h"

#include <firsthit/scene.h>

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

void raster_batch(const ViewMemory& view, ItemTile& tile)
{
    Batch& batch = tile.batch;
    const hn::CappedTag<double, 8> d;
    for (int i = 0; i < batch.count; i += int(hn::Lanes(d)))
        set_up_lanes(d, batch, i, tile.rays.x0, tile.rays.y0);
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
            decide_box(view, tile, i);
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
    // Small triangles are rasterised by quads of 4 samples, large ones by blocks of 8.
    const bool large = std::max(entry.x1 - entry.x0, entry.y1 - entry.y0) >= 16;
    const int align = large ? 7 : 3;
    batch.x0[i] = entry.x0, batch.y0[i] = entry.y0, batch.x1[i] = entry.x1, batch.y1[i] = entry.y1;
    batch.origin_x[i] = entry.x0 & ~align, batch.origin_y[i] = entry.y0 & ~align;
    batch.extent_x[i] = (entry.x1 | align) - batch.origin_x[i];
    batch.extent_y[i] = (entry.y1 | align) - batch.origin_y[i];
}

/// Sorts entries nearest first, by classes of 6% of depth. The sort is stable, so that triangles of
/// one surface stay in order.
void sort_chunk(std::span<const TileEntry> chunk, ItemTile& tile)
{
    std::uint16_t start[257] = {};
    for (std::size_t k = 0; k < chunk.size(); ++k) {
        const float z = chunk[k].nearest_z;
        // The upper bits of a float (sign, exponent, four bits of mantissa) are ordered like z.
        const int depth = z > 0 ? int(std::bit_cast<std::uint32_t>(z) >> 19) - (127 - 8) * 16 : 0;
        tile.chunk_depth[k] = std::uint8_t(std::clamp(depth, 0, 255));
        ++start[tile.chunk_depth[k] + 1];
    }
    for (int depth = 0; depth < 256; ++depth)
        start[depth + 1] = std::uint16_t(start[depth + 1] + start[depth]);
    for (std::size_t k = 0; k < chunk.size(); ++k)
        tile.chunk_order[start[tile.chunk_depth[k]]++] = std::uint16_t(k);
}

/// Whether the stored triangles certainly hide the entry. Uses the least w of blocks, which may be
/// out of date; then it finds less.
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

/// Prefetches indices and corners of the entries ahead.
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

/// Merges the fragments [first, last) of the view into the tile.
void merge(const ViewMemory& view, std::size_t first, std::size_t last, ItemTile& tile)
{
    if (first == last) return;
    float* HWY_RESTRICT stored_w = tile.w.data();
    std::uint32_t* HWY_RESTRICT stored_item = tile.item.data();
    for (const Fragment& fragment : view.fragment.span().subspan(first, last - first)) {
        const std::uint32_t offset = fragment.place & 0xFFFF, triangle = fragment.triangle;
        const float w = fragment.w, stored = stored_w[offset];
        const float ahead = w - stored, slack = stored * kDepthSlack;
        const bool win = ahead > slack;
        if (!win && !(ahead < -slack)) [[unlikely]] {
            decide_fragment_exactly(view, tile, triangle, offset, w);
            continue;
        }
        // Without a branch, which would often be mispredicted.
        stored_w[offset] = std::max(w, stored);
        stored_item[offset] = win ? triangle : stored_item[offset];
    }
    for (int block = 0; block < tile.blocks(); ++block)
        tile.stale[block >> 6] |= std::uint64_t(1) << (block & 63);
    refresh_blocks(tile);
}

void raster_entries(const ViewMemory& view, std::size_t number, ItemTile& tile)
{
    const auto entries = view.entry.span().subspan(
        view.tile_start[number], view.tile_start[number + 1] - view.tile_start[number]);
    // The first batches are small: after each, the triangles that follow can be tested against what
    // the nearest ones hide.
    int full = kFirstBatch;
    clear(tile);
    merge(view, view.fragment_start[number], view.fragment_start[number + 1], tile);
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
            if (tile.batch.count == full) {
                raster_batch(view, tile);
                refresh_blocks(tile);
                full = std::min(2 * full, kBatch);
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
    out.rays = view.pencil.tile(tx * view.tile_size, ty * view.tile_size);
    HWY_DYNAMIC_DISPATCH(raster_entries)(view, std::size_t(tile), out);
}

} // namespace firsthit
#endif
