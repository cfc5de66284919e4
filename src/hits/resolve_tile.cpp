// resolve_tile.cpp - finds where exactly each sample's ray hits the triangle that the sample sees.
//
// Neighbouring samples mostly see the same triangle. It is loaded and set up once for each block in
// which it is seen, and is then intersected with the registers of its samples only. In blocks with
// many triangles each sample sets up its own one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hits/resolve_tile.cpp"
#include "base/simd.h"

#include "hits/block_samples.h"
#include "hits/item_runs-inl.h"
#include "hits/lane_hits-inl.h"
#include "hits/resolve_runs-inl.h"
#include "hits/resolve_samples-inl.h"
#include "hits/resolve_tile.h"
#include "visibility/triangle_planes-inl.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

constexpr int kRuns = 64; // runs of a batch

/// If a block has at least so many runs, its samples are set up one by one (measured).
constexpr std::size_t kManyRuns = 5;

/// If a block has at least so many runs, its samples pick theirs (resolve_runs), where the
/// instruction set allows (measured).
[[maybe_unused]] constexpr std::size_t kSomeRuns = 3;

/// A batch of runs and the planes of their triangles, structure of arrays.
struct RunBatch {
    int count = 0;
    HitRun* run[kRuns];
    alignas(64) float corner[9][kRuns];
    alignas(64) double n[3][kRuns]; // see LanePlanes
    alignas(64) double edge1[3][kRuns];
    alignas(64) double edge2[3][kRuns];
    alignas(64) double volume[kRuns];
    std::uint64_t doubtful = 0;         // a bit for each run, see DoubtfulTriangles
    alignas(64) glm::vec4 plane[kRuns]; // see HitRun

    Corners corners(int i) const
    {
        return {glm::vec3(corner[0][i], corner[1][i], corner[2][i]),
            glm::vec3(corner[3][i], corner[4][i], corner[5][i]),
            glm::vec3(corner[6][i], corner[7][i], corner[8][i])};
    }

    LanePlanes planes(int i) const
    {
        const Doubles d;
        const auto same = [&](const double(&v)[3][kRuns]) {
            return Vector3<DoubleLanes>{
                hn::Set(d, v[0][i]), hn::Set(d, v[1][i]), hn::Set(d, v[2][i])};
        };
        return {same(n), same(edge1), same(edge2), hn::Set(d, volume[i])};
    }
};

/// Writes to the places of a block what samples without an item have.
void fill_misses(int block, const HitPlaces& places)
{
    const int first = block * kBlockSamples;
    std::fill_n(places.t + first, kBlockSamples, std::numeric_limits<float>::infinity());
    std::fill_n(places.u + first, kBlockSamples, 0.0f);
    std::fill_n(places.v + first, kBlockSamples, 0.0f);
}

/// Appends the runs of a block in the order of their first samples, and returns the end.
///
/// item  (64) of the block
/// rest  bits of the samples that have an item
HWY_INLINE HitRun* find_block_runs(
    const std::uint32_t* item, int block, std::uint64_t rest, HitRun* next)
{
    // Find the first runs one after the other. Each one removes its samples from the rest, so this
    // is a chain of dependent steps of some 25 cycles a run.
    for (int few = 0; few < 8; ++few) {
        if (rest == 0) return next;
        const std::uint32_t id = item[std::countr_zero(rest)];
        const std::uint64_t samples = samples_with(item, id);
        *next++ = {.item = id, .block = std::uint16_t(block), .samples = samples};
        rest &= ~samples;
    }
    // There are many runs. Find the run of each remaining sample independently of the others; it
    // counts only for its first sample.
    for (; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        const std::uint64_t samples = samples_with(item, item[k]);
        *next = {.item = item[k], .block = std::uint16_t(block), .samples = samples};
        next += std::countr_zero(samples) == k;
    }
    return next;
}

/// Finds the runs of all blocks, and fills `covered` and what samples without an item have. Returns
/// the number of runs.
std::size_t find_runs(const TileItems& items, const HitPlaces& places)
{
    HitRun* next = places.run;
    for (int block = 0; block < items.blocks(); ++block) {
        const std::uint32_t* item = items.item.data() + block * kBlockSamples;
        const std::uint64_t covered = ~samples_with(item, kNoItem);
        places.covered[block] = covered;
        if (covered == 0 && !places.misses) continue;
        if (~covered) fill_misses(block, places);
        if (places.items) std::copy_n(item, kBlockSamples, places.item + block * kBlockSamples);
        next = find_block_runs(item, block, covered, next);
    }
    return std::size_t(next - places.run);
}

/// Computes the planes of the batch's runs.
void set_up_runs(const TileResolve& tile, RunBatch& batch)
{
    const EyeMesh& mesh = tile.mesh;
    static_assert(kRuns == 64, "doubtful has a bit for each run");
    batch.doubtful = 0;
    for (int i = 0; i < batch.count; ++i) {
        const glm::uvec3 index = mesh.index[batch.run[i]->item];
        for (int k = 0; k < 3; ++k) {
            const glm::vec4& p = mesh.corner[index[k]];
            batch.corner[3 * k][i] = p.x;
            batch.corner[3 * k + 1][i] = p.y;
            batch.corner[3 * k + 2][i] = p.z;
        }
    }
    const Doubles d;
    const Floats f;
    using V = DoubleLanes;
    for (int i = 0; i < batch.count; i += kHitLanes) {
        const auto load = [&](int axis) {
            return hn::PromoteTo(d, hn::Load(f, batch.corner[axis] + i));
        };
        const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
            v2{load(6), load(7), load(8)};
        const Planes<V> p = planes_of_corners(tile, v0, v1, v2);
        const auto store = [&](const Vector3<V>& v, double(&to)[3][kRuns]) {
            hn::Store(v.x, d, to[0] + i);
            hn::Store(v.y, d, to[1] + i);
            hn::Store(v.z, d, to[2] + i);
        };
        store(p.n, batch.n);
        store(p.edge[1], batch.edge1);
        store(p.edge[2], batch.edge2);
        hn::Store(p.volume, d, batch.volume + i);
        batch.doubtful |= tile.doubtful.find(v0, v1, v2, p.volume) << i;
        tile.world.store(p.n, p.volume, batch.plane, i);
    }
}

/// Finds the hits of the batch's runs, and their sides and planes. The batch is empty afterwards.
void resolve_batch(const TileResolve& tile, RunBatch& batch)
{
    set_up_runs(tile, batch);
    for (int i = 0; i < batch.count; ++i) {
        HitRun& run = *batch.run[i];
        run.eye_side = side_of(batch.volume[i]);
        run.plane = batch.plane[i];
        const LatticeTile rays = tile.items.block_rays(run.block);
        const LanePlanes planes = batch.planes(i);
        for (int first = 0; first < kBlockSamples; first += kHitLanes) {
            const std::uint64_t samples = run.samples >> first & kAllHitLanes;
            if (samples != 0) meet(planes, rays, {run.block, first, samples}, tile);
        }
        if (batch.doubtful >> i & 1) [[unlikely]]
            settle_run(batch.corners(i), tile, rays, run);
    }
    batch.count = 0;
}

/// Prefetches the triangles of runs that come soon: first their index, later their corners. Tiny
/// triangles were rasterised before the tiles, so their memory has not been used lately.
class RunPrefetch {
  public:
    RunPrefetch(const EyeMesh& mesh, std::span<const HitRun> runs) : mesh_(mesh), runs_(runs) {}

    /// Prefetches what comes after the first `done` runs.
    HWY_INLINE void advance(std::size_t done)
    {
        constexpr std::size_t kCorners = 96, kIndices = 192; // runs ahead
        for (const std::size_t end = std::min(runs_.size(), done + kIndices); index_ < end;
             ++index_)
            __builtin_prefetch(&mesh_.index[runs_[index_].item]);
        corner_ = std::max(corner_, done);
        for (const std::size_t end = std::min(runs_.size(), done + kCorners); corner_ < end;
             ++corner_) {
            const glm::uvec3& index = mesh_.index[runs_[corner_].item];
            for (int k = 0; k < 3; ++k) __builtin_prefetch(&mesh_.corner[index[k]]);
        }
    }

  private:
    const EyeMesh& mesh_;
    std::span<const HitRun> runs_;
    std::size_t index_ = 0, corner_ = 0; // runs whose index and whose corners were prefetched
};

/// Returns the number of runs.
std::size_t resolve(
    const EyeMesh& mesh, const Pencil& pencil, const TileItems& items, const HitPlaces& places)
{
    const std::size_t count = find_runs(items, places);
    RunPrefetch prefetch(mesh, {places.run, count});
    const WorldPlanes world(pencil);
    const DoubtfulTriangles doubtful(items);
    const TileResolve tile{mesh, pencil, items, world, doubtful, places};
    RunBatch batch;
    for (float(&axis)[kRuns] : batch.corner) std::fill_n(axis, kRuns, 0.0f);
    for (std::size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && places.run[end].block == places.run[first].block;)
            ++end;
        const std::span<HitRun> runs(places.run + first, end - first);
        if (runs.size() >= kManyRuns) prefetch.advance(end);
#if HWY_TARGET == HWY_AVX3
        if (runs.size() >= kSomeRuns && runs.size() <= kMostRunLanes) {
            resolve_runs(tile, runs);
            continue;
        }
#endif
        if (runs.size() >= kManyRuns) {
            resolve_samples(tile, runs);
            continue;
        }
        for (HitRun& run : runs) {
            batch.run[batch.count++] = &run;
            if (batch.count == kRuns) resolve_batch(tile, batch);
        }
    }
    resolve_batch(tile, batch);
    return count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(resolve);

void resize(HitMemory& memory, int tile_size, std::size_t tiles)
{
    memory.samples = std::size_t(tile_size) * std::size_t(tile_size);
    memory.run.resize(tiles * memory.samples);
    memory.covered.resize(tiles * memory.samples / kBlockSamples);
    memory.item.resize(tiles * memory.samples);
    for (Buffer<float>* plane : {&memory.t, &memory.u, &memory.v})
        plane->resize(tiles * memory.samples);
}

HitTile resolve_tile(
    const EyeMesh& mesh, const Pencil& pencil, const TileItems& items, const HitPlaces& places)
{
    const std::size_t runs = HWY_DYNAMIC_DISPATCH(resolve)(mesh, pencil, items, places);
    HitTile hits;
    hits.size = items.size;
    hits.rays = world_rays(pencil, items.rays);
    hits.runs = std::span<const HitRun>(places.run, runs);
    hits.covered = places.covered;
    hits.item = places.items ? places.item : nullptr;
    hits.t = places.t;
    hits.u = places.u;
    hits.v = places.v;
    return hits;
}

} // namespace firsthit
#endif
