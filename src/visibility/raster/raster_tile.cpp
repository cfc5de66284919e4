// raster_tile.cpp - rasterises the items of one tile. Triangles are sorted nearest first, so that
// hidden ones can be skipped, and are rasterised by a kernel for their size.
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

/// Gives the cut-outs of the batch kernels that ask for the opacity at each sample. Kernel::exact
/// does so anyway.
void mark_cutouts(const Cutouts& cutouts, Batch& batch)
{
    for (int i = 0; i < batch.count; ++i) {
        Kernel& kernel = batch.kernel[i];
        if (!cutouts.has(batch.triangle[i])) continue;
        if (kernel == Kernel::wide)
            kernel = Kernel::wide_cutout;
        else if (kernel != Kernel::none && kernel != Kernel::exact)
            kernel = Kernel::cutout;
    }
}

/// Rasterises the triangles of the batch, which is empty afterwards.
void raster_batch(const TileInWork& tile)
{
    Batch& batch = tile.scratch.batch;
    const hn::CappedTag<double, 8> d;
    for (int i = 0; i < batch.count; i += int(hn::Lanes(d)))
        set_up_lanes(d, batch, i, tile.items.rays);
    if (tile.mesh.cutouts.any()) mark_cutouts(tile.mesh.cutouts, batch);
    for (int i = 0; i < batch.count; ++i) {
        const Box box{batch.x0[i], batch.y0[i], batch.x1[i], batch.y1[i]};
        switch (batch.kernel[i]) {
        case Kernel::none:
            continue;
        case Kernel::tiny:
            store_tiny(tile, i);
            break;
        case Kernel::small:
            raster_box<false, false>(Samples(), tile, i, box);
            break;
        case Kernel::large:
            raster_blocks(tile, i);
            continue;
        case Kernel::wide:
            raster_box<false, true>(WideSamples(), tile, i, box);
            break;
        case Kernel::cutout:
            raster_cutout<false>(Samples(), tile, i, box);
            break;
        case Kernel::wide_cutout:
            raster_cutout<true>(WideSamples(), tile, i, box);
            break;
        case Kernel::exact:
            decide_box(tile, i);
            break;
        }
        mark_stale(tile, box);
    }
    batch.count = 0;
}

/// Appends the triangle of an entry to the batch.
HWY_INLINE void gather(const EyeMesh& mesh, const TileEntry& entry, float nearest_w, Batch& batch)
{
    const int i = batch.count++;
    batch.triangle[i] = entry.triangle;
    batch.nearest_w[i] = nearest_w;
    const glm::uvec3 index = mesh.index[entry.triangle];
    for (int k = 0; k < 3; ++k) {
        const glm::vec4& p = mesh.corner[index[k]];
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
/// one surface stay in order. Fills chunk_order.
void sort_chunk(std::span<const TileEntry> chunk, RasterScratch& scratch)
{
    std::uint16_t start[257] = {};
    for (std::size_t k = 0; k < chunk.size(); ++k) {
        const float z = chunk[k].nearest_z;
        // The upper bits of a float (sign, exponent, four bits of mantissa) are ordered like z.
        const int depth = z > 0 ? int(std::bit_cast<std::uint32_t>(z) >> 19) - (127 - 8) * 16 : 0;
        scratch.chunk_depth[k] = std::uint8_t(std::clamp(depth, 0, 255));
        ++start[scratch.chunk_depth[k] + 1];
    }
    for (int depth = 0; depth < 256; ++depth)
        start[depth + 1] = std::uint16_t(start[depth + 1] + start[depth]);
    for (std::size_t k = 0; k < chunk.size(); ++k)
        scratch.chunk_order[start[scratch.chunk_depth[k]]++] = std::uint16_t(k);
}

/// Whether the stored triangles certainly hide the entry's triangle. Uses the least w of blocks,
/// which may be out of date; then fewer hidden triangles are found.
///
/// blocks_x  number of blocks in a row of the tile
HWY_INLINE bool entry_hidden(
    const RasterScratch& scratch, const TileEntry& entry, float nearest_w, int blocks_x)
{
    if (is_hidden(nearest_w, scratch.least_w)) return true;
    const int bx0 = entry.x0 / kBlock, bx1 = entry.x1 / kBlock;
    const int by0 = entry.y0 / kBlock, by1 = entry.y1 / kBlock;
    if (bx1 - bx0 > 1 || by1 - by0 > 1) return false;
    const float* row0 = scratch.block_w + by0 * blocks_x;
    const float* row1 = scratch.block_w + by1 * blocks_x;
    return is_hidden(nearest_w, std::min({row0[bx0], row0[bx1], row1[bx0], row1[bx1]}));
}

/// Prefetches the index and the corners of entries that come soon after number n of the sorted
/// chunk.
HWY_INLINE void prefetch(const EyeMesh& mesh, std::span<const TileEntry> chunk,
    const std::uint16_t* chunk_order, std::size_t n)
{
    constexpr std::size_t kIndices = 24, kCorners = 12; // entries ahead
    if (n + kIndices < chunk.size())
        hwy::Prefetch(&mesh.index[chunk[chunk_order[n + kIndices]].triangle]);
    if (n + kCorners < chunk.size()) {
        const glm::uvec3& index = mesh.index[chunk[chunk_order[n + kCorners]].triangle];
        for (int k = 0; k < 3; ++k) hwy::Prefetch(&mesh.corner[index[k]]);
    }
}

/// Hides the samples that are not asked for: what is stored there is nearer than any triangle.
void hide_unwanted(std::span<const std::uint64_t> wanted, RasterScratch& scratch)
{
    constexpr float kNearest = 0x1p124f;
    static_assert(kNearest - kGreatestW > kNearest * kDepthSlack, "every w is certainly behind it");
    for (std::size_t block = 0; block < wanted.size(); ++block) {
        float* w = scratch.w.data() + block * kBlockSamples;
        if (wanted[block] == 0) {
            std::fill_n(w, kBlockSamples, kNearest);
            scratch.block_w[block] = kNearest;
            continue;
        }
        for (std::uint64_t rest = ~wanted[block]; rest; rest &= rest - 1)
            w[std::countr_zero(rest)] = kNearest;
    }
}

/// Begins a tile without any items.
void clear(TileItems& items, RasterScratch& scratch)
{
    const std::size_t samples = std::size_t(items.size) * std::size_t(items.size);
    std::fill_n(scratch.w.data(), samples, 0.0f);
    std::fill_n(items.item.data(), samples, kNoItem);
    std::fill_n(scratch.block_w, items.blocks(), 0.0f);
    std::fill_n(scratch.stale, 4, std::uint64_t(0));
    scratch.least_w = 0;
    scratch.coplanar = {};
    items.counts = {};
    if (!items.wanted.empty()) hide_unwanted(items.wanted, scratch);
}

/// Stores the fragments that are nearer than what is stored.
void merge(const TileInWork& tile, std::span<const Fragment> fragments)
{
    if (fragments.empty()) return;
    RasterScratch& scratch = tile.scratch;
    const int blocks = tile.items.blocks();
    float* HWY_RESTRICT stored_w = scratch.w.data();
    std::uint32_t* HWY_RESTRICT stored_item = tile.items.item.data();
    for (const Fragment& fragment : fragments) {
        const std::uint32_t offset = fragment.sample & 0xFFFF, triangle = fragment.triangle;
        const float w = fragment.w, stored = stored_w[offset];
        const float ahead = w - stored, slack = stored * kDepthSlack;
        const bool win = ahead > slack;
        if (!win && !(ahead < -slack)) [[unlikely]] {
            decide_fragment_exactly(tile, fragment);
            continue;
        }
        // Without a branch, which would often be mispredicted.
        stored_w[offset] = std::max(w, stored);
        stored_item[offset] = win ? triangle : stored_item[offset];
    }
    for (int block = 0; block < blocks; ++block) mark_stale(scratch, block);
    refresh_blocks(scratch, blocks);
}

void raster_bin(const TileInWork& tile, const TileBin<Fragment>& bin)
{
    const EyeMesh& mesh = tile.mesh;
    RasterScratch& scratch = tile.scratch;
    const int blocks = tile.items.blocks(), blocks_x = tile.items.blocks_x();
    const std::span<const TileEntry> entries = bin.entries;
    // The first batches are small: after each batch, the triangles that follow are tested against
    // what it hides.
    int full = kFirstBatch;
    clear(tile.items, scratch);
    merge(tile, bin.fragments);
    for (std::size_t first = 0; first < entries.size(); first += RasterScratch::kChunk) {
        const auto chunk =
            entries.subspan(first, std::min(RasterScratch::kChunk, entries.size() - first));
        sort_chunk(chunk, scratch);
        for (std::size_t n = 0; n < chunk.size(); ++n) {
            prefetch(mesh, chunk, scratch.chunk_order, n);
            const TileEntry& entry = chunk[scratch.chunk_order[n]];
            const float z = entry.nearest_z;
            const float nearest_w = z > 0 ? 1 / z : std::numeric_limits<float>::infinity();
            if (entry_hidden(scratch, entry, nearest_w, blocks_x)) continue;
            gather(mesh, entry, nearest_w, scratch.batch);
            if (scratch.batch.count == full) {
                raster_batch(tile);
                refresh_blocks(scratch, blocks);
                full = std::min(2 * full, kBatch);
            }
        }
    }
    raster_batch(tile);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(raster_bin);

void resize(RasterScratch& scratch, int size)
{
    scratch.w.resize(std::size_t(size) * std::size_t(size));
    for (int k = 0; k < size; ++k) {
        scratch.column_offset[k] = tile_offset(k, 0, size);
        scratch.row_offset[k] = tile_offset(0, k, size);
    }
}

void raster_tile(const EyeMesh& mesh, const LatticeTile& rays, const TileBin<Fragment>& bin,
    TileItems& out, RasterScratch& scratch)
{
    out.rays = rays;
    HWY_DYNAMIC_DISPATCH(raster_bin)({mesh, out, scratch}, bin);
}

} // namespace firsthit
#endif
