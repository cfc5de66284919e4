// decide_exactly.cpp - decides samples exactly where the rasteriser's floats are uncertain.
#include "visibility/raster/decide_exactly.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <bit>

namespace firsthit {
namespace {

Corners corners_of(const ViewMemory& view, std::uint32_t triangle)
{
    const glm::uvec3& corner = view.index[triangle];
    return {glm::vec3(view.corner[corner.x]), glm::vec3(view.corner[corner.y]),
        glm::vec3(view.corner[corner.z])};
}

/// Whether triangle a is nearer than the stored triangle b, or equally near with a lower id. The
/// ray along d hits both, and their w are too close to decide.
bool is_nearer(const ViewMemory& view, ItemTile& tile, std::uint32_t a, const Corners& corners_a,
    std::uint32_t b, const glm::vec3& d)
{
    CoplanarCache::Pair& known = tile.coplanar.pair[((a * 0x9E3779B1u) ^ (b * 0x85EBCA77u)) >> 26];
    const bool seen = known.a == a && known.b == b;
    if (seen && known.coplanar) return a < b;
    const Corners corners_b = corners_of(view, b);
    if (const int certain = compare_depth_fast(corners_a, corners_b, d)) return certain < 0;
    if (!seen) {
        ++tile.counts.effort.exact_calls;
        known = {a, b, are_coplanar(corners_a, corners_b)};
        if (known.coplanar) return a < b;
    }
    const int order = compare_depth(corners_a, corners_b, d, tile.counts.effort);
    return order < 0 || (order == 0 && a < b);
}

/// Stores triangle a at a sample that it covers, if it is nearer than the stored triangle.
void store_if_nearer(const ViewMemory& view, ItemTile& tile, std::uint32_t a,
    const Corners& corners, std::size_t offset, float w, const glm::vec3& d)
{
    const float stored = tile.w[offset];
    const float slack = stored * kDepthSlack;
    if (w - stored < -slack) return;
    if (!(w - stored > slack) && tile.item[offset] != kNoItem) {
        ++tile.counts.ambiguous;
        if (!is_nearer(view, tile, a, corners, tile.item[offset], d)) return;
    }
    tile.w[offset] = w;
    tile.item[offset] = a;
}

} // namespace

void decide_lanes_exactly(const ViewMemory& view, ItemTile& tile, int i, const Lanes& lanes,
    std::uint64_t open, std::uint64_t inside, const float* w)
{
    const Corners corners = tile.batch.corners(i);
    for (; open; open &= open - 1) {
        const int lane = std::countr_zero(open);
        const glm::vec3 d =
            tile.rays.direction(lanes.x + lane % lanes.columns, lanes.y + lane / lanes.columns);
        if (!(inside >> lane & 1)) {
            ++tile.counts.uncertain;
            if (!is_hit(corners, d, tile.counts.effort)) continue;
        }
        store_if_nearer(view, tile, tile.batch.triangle[i], corners,
            std::size_t(lanes.offset + lane), w[lane], d);
    }
}

void decide_fragment_exactly(
    const ViewMemory& view, ItemTile& tile, std::uint32_t triangle, std::uint32_t offset, float w)
{
    const int block = int(offset) / kBlockSamples, inner = int(offset) % kBlockSamples;
    const int x = block % tile.blocks_x() * kBlock + block_x(inner);
    const int y = block / tile.blocks_x() * kBlock + block_y(inner);
    store_if_nearer(
        view, tile, triangle, corners_of(view, triangle), offset, w, tile.rays.direction(x, y));
}

void decide_box(const ViewMemory& view, ItemTile& tile, int i)
{
    const Batch& batch = tile.batch;
    const Corners corners = batch.corners(i);
    if (volume_sign(corners, tile.counts.effort) == 0) return; // edge-on: no ray hits it
    for (int y = batch.y0[i]; y <= batch.y1[i]; ++y) {
        for (int x = batch.x0[i]; x <= batch.x1[i]; ++x) {
            const glm::vec3 d = tile.rays.direction(x, y);
            ++tile.counts.uncertain;
            if (!is_hit(corners, d, tile.counts.effort)) continue;
            const float w = float(std::min(exact_inverse_depth(corners, d), double(kGreatestW)));
            const int offset = tile.column_offset[x] + tile.row_offset[y];
            store_if_nearer(view, tile, batch.triangle[i], corners, std::size_t(offset), w, d);
        }
    }
}

} // namespace firsthit
