// decide_exactly.cpp - decides samples exactly where the rasteriser's floats are uncertain.
#include "visibility/raster/decide_exactly.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <bit>

namespace firsthit {
namespace {

struct Candidate {
    std::uint32_t triangle;
    Corners corners;
    bool is_cutout;
};

Candidate candidate_of(const TileInWork& tile, std::uint32_t triangle, const Corners& corners)
{
    return {triangle, corners, tile.mesh.cutouts.has(triangle)};
}

/// Whether triangle a is nearer than the stored triangle b, or equally near with a lower id. The
/// ray along d hits both, and their w are too close to decide.
bool is_nearer(
    const TileInWork& tile, const Candidate& candidate, std::uint32_t b, const glm::vec3& d)
{
    const std::uint32_t a = candidate.triangle;
    Effort& effort = tile.items.counts.effort;
    CoplanarCache::Pair& known =
        tile.scratch.coplanar.pair[((a * 0x9E3779B1u) ^ (b * 0x85EBCA77u)) >> 26];
    const bool seen = known.a == a && known.b == b;
    if (seen && known.coplanar) return a < b;
    const Corners corners_b = corners_of(tile.mesh, b);
    if (const int certain = compare_depth_fast(candidate.corners, corners_b, d)) return certain < 0;
    if (!seen) {
        ++effort.exact_calls;
        known = {a, b, are_coplanar(candidate.corners, corners_b)};
        if (known.coplanar) return a < b;
    }
    const int order = compare_depth(candidate.corners, corners_b, d, effort);
    return order < 0 || (order == 0 && a < b);
}

/// Stores a triangle at a sample that it covers, if it is nearer than the stored triangle, and, as a
/// cut-out, if it is there.
///
/// offset  of the sample in the tile
/// w       1/t of the triangle there
/// d       direction of the sample's ray
void store_if_nearer(const TileInWork& tile, const Candidate& candidate, std::size_t offset,
    float w, const glm::vec3& d)
{
    float& stored_w = tile.scratch.w[offset];
    std::uint32_t& stored_item = tile.items.item[offset];
    const float slack = stored_w * kDepthSlack;
    if (w - stored_w < -slack) return;
    if (!(w - stored_w > slack) && stored_item != kNoItem) {
        ++tile.items.counts.ambiguous;
        if (!is_nearer(tile, candidate, stored_item, d)) return;
    }
    if (candidate.is_cutout &&
        !tile.mesh.cutouts.is_solid(candidate.triangle, candidate.corners, d))
        return;
    stored_w = w;
    stored_item = candidate.triangle;
}

} // namespace

void decide_lanes_exactly(const TileInWork& tile, int i, const OpenLanes& lanes)
{
    const Batch& batch = tile.scratch.batch;
    TileCounts& counts = tile.items.counts;
    const Candidate candidate = candidate_of(tile, batch.triangle[i], batch.corners(i));
    for (std::uint64_t open = lanes.open; open; open &= open - 1) {
        const int lane = std::countr_zero(open);
        const glm::vec3 d = tile.items.rays.direction(
            lanes.x + lane % lanes.columns, lanes.y + lane / lanes.columns);
        if (!(lanes.inside >> lane & 1)) {
            ++counts.uncertain;
            if (!is_hit(candidate.corners, d, counts.effort)) continue;
        }
        store_if_nearer(tile, candidate, std::size_t(lanes.offset + lane), lanes.w[lane], d);
    }
}

void decide_fragment_exactly(const TileInWork& tile, const Fragment& fragment)
{
    const std::uint32_t offset = fragment.sample & 0xFFFF;
    const int block = int(offset) / kBlockSamples, inner = int(offset) % kBlockSamples;
    const glm::vec3 d = tile.items.block_rays(block).direction(block_x(inner), block_y(inner));
    const Corners corners = corners_of(tile.mesh, fragment.triangle);
    store_if_nearer(tile, candidate_of(tile, fragment.triangle, corners), offset, fragment.w, d);
}

void decide_box(const TileInWork& tile, int i)
{
    const RasterScratch& scratch = tile.scratch;
    const Batch& batch = scratch.batch;
    TileCounts& counts = tile.items.counts;
    const Candidate candidate = candidate_of(tile, batch.triangle[i], batch.corners(i));
    if (volume_sign(candidate.corners, counts.effort) == 0) return; // edge-on: no ray hits it
    for (int y = batch.y0[i]; y <= batch.y1[i]; ++y) {
        for (int x = batch.x0[i]; x <= batch.x1[i]; ++x) {
            const glm::vec3 d = tile.items.rays.direction(x, y);
            ++counts.uncertain;
            if (!is_hit(candidate.corners, d, counts.effort)) continue;
            const double exact = exact_inverse_depth(candidate.corners, d);
            const float w = float(std::min(exact, double(kGreatestW)));
            const int offset = scratch.column_offset[x] + scratch.row_offset[y];
            store_if_nearer(tile, candidate, std::size_t(offset), w, d);
        }
    }
}

} // namespace firsthit
