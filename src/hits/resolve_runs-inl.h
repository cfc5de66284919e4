// resolve_runs-inl.h - finds the hits of a block that sees several triangles, but many fewer than
// it has samples.
//
// The triangles of the block are set up side by side, and then each sample picks its own one. So
// every register of samples is intersected once, wherever its runs lie.
#if defined(FIRSTHIT_HITS_RESOLVE_RUNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_RESOLVE_RUNS_INL_H_
#undef FIRSTHIT_HITS_RESOLVE_RUNS_INL_H_
#else
#define FIRSTHIT_HITS_RESOLVE_RUNS_INL_H_
#endif

#include "hits/lane_hits-inl.h"
#include "hits/resolve_samples-inl.h"
#include "hits/run_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
/// The planes of the triangles of a block's runs, a column for each run.
struct RunPlanes {
    static constexpr std::size_t kRuns = kMostRunLanes;
    alignas(64) double n[3][kRuns], edge1[3][kRuns], edge2[3][kRuns]; // see LanePlanes
    alignas(64) double volume[kRuns];
    std::uint64_t doubtful = 0;         // a bit for each run, see DoubtfulTriangles
    alignas(64) glm::vec4 plane[kRuns]; // see HitRun
};

HWY_INLINE void set_up_planes(const TileResolve& tile, std::span<const HitRun> runs, RunPlanes& out)
{
    const EyeMesh& mesh = tile.mesh;
    const Doubles d;
    for (std::size_t i = 0; i < runs.size(); i += kHitLanes) {
        glm::uvec3 index[kHitLanes];
        for (std::size_t lane = 0; lane < kHitLanes; ++lane)
            index[lane] = mesh.index[runs[i + lane < runs.size() ? i + lane : 0].item];
        const auto c0 = fetch_corner(mesh, index, 0), c1 = fetch_corner(mesh, index, 1),
                   c2 = fetch_corner(mesh, index, 2);
        const Vector3<DoubleLanes> v0 = wide(c0), v1 = wide(c1), v2 = wide(c2);
        const Planes<DoubleLanes> p = planes_of_corners(tile, v0, v1, v2);
        const auto keep = [&](const Vector3<DoubleLanes>& v, double(&to)[3][RunPlanes::kRuns]) {
            hn::Store(v.x, d, to[0] + i);
            hn::Store(v.y, d, to[1] + i);
            hn::Store(v.z, d, to[2] + i);
        };
        keep(p.n, out.n);
        keep(p.edge[1], out.edge1);
        keep(p.edge[2], out.edge2);
        hn::Store(p.volume, d, out.volume + i);
        out.doubtful |= tile.doubtful.find(v0, v1, v2, p.volume) << i;
        tile.world.store(p.n, p.volume, out.plane, int(i));
    }
}

/// Finds the hits of a block, and the sides and planes of its runs.
///
/// runs  all runs of the block, at most kMostRunLanes
HWY_INLINE void resolve_runs(const TileResolve& tile, std::span<HitRun> runs)
{
    const LatticeTile rays = tile.items.block_rays(runs[0].block);
    RunPlanes table;
    set_up_planes(tile, runs, table);
    std::uint64_t covered = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        HitRun& run = runs[k];
        covered |= run.samples;
        run.eye_side = side_of(table.volume[k]);
        run.plane = table.plane[k];
    }
    const RunLanes lanes(runs);
    for (int first = 0; first < kBlockSamples; first += kHitLanes) {
        const std::uint64_t samples = covered >> first & kAllHitLanes;
        if (samples == 0) continue;
        const auto pick = [&](const double(&from)[RunPlanes::kRuns]) {
            return DoubleLanes{lanes.of_samples(first, from)};
        };
        const auto pick3 = [&](const double(&from)[3][RunPlanes::kRuns]) {
            return Vector3<DoubleLanes>{pick(from[0]), pick(from[1]), pick(from[2])};
        };
        const LanePlanes planes{
            pick3(table.n), pick3(table.edge1), pick3(table.edge2), pick(table.volume)};
        meet(planes, rays, {runs[0].block, first, samples}, tile);
    }
    // Lanes beyond the last run have the first run's triangle, and are left out here.
    for (std::uint64_t rest = table.doubtful & ((std::uint64_t(1) << runs.size()) - 1); rest;
         rest &= rest - 1) {
        HitRun& run = runs[std::size_t(std::countr_zero(rest))]; // seldom
        settle_run(corners_of(tile.mesh, run.item), tile, rays, run);
    }
}
#endif

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
