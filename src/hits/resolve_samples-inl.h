// resolve_samples-inl.h - finds the hits of a block whose samples mostly see different triangles.
//
// Each lane of a register loads and sets up its own triangle, so a triangle that several samples
// see is set up several times.
#if defined(FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#undef FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#else
#define FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#endif

#include "hits/lane_hits-inl.h"
#include "visibility/bin/eye_mesh.h"

#include <firsthit/scene.h>

#include <span>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Loads corner number `corner` of each lane's triangle.
///
/// index  (lanes) the vertices of the triangles
HWY_INLINE Vector3<FloatLanes> fetch_corner(
    const EyeMesh& mesh, const glm::uvec3* index, int corner)
{
    const Floats f;
    const auto place = [&](int lane) { return &mesh.corner[index[lane][corner]].x; };
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    // Transpose one or two 4x4 matrices. That of lanes 0 to 3 is in the lower halves of the
    // registers.
    const auto rows = [&](int lane) {
        const hn::CappedTag<float, 4> four;
        const auto low = hn::Load(four, place(lane));
#if HWY_TARGET == HWY_AVX3
        return hn::Combine(f, hn::Load(four, place(lane + 4)), low);
#else
        return low;
#endif
    };
    const hn::Repartition<double, Floats> pairs;
    const auto v0 = rows(0), v1 = rows(1), v2 = rows(2), v3 = rows(3);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(f, v0, v1)); // x0 x1 y0 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(f, v2, v3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(f, v0, v1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(f, v2, v3));
    return {hn::BitCast(f, hn::InterleaveLower(pairs, xy01, xy23)),
        hn::BitCast(f, hn::InterleaveUpper(pairs, xy01, xy23)),
        hn::BitCast(f, hn::InterleaveLower(pairs, z01, z23))};
#else
    alignas(64) float at[3][kHitLanes];
    for (int lane = 0; lane < kHitLanes; ++lane)
        for (int axis = 0; axis < 3; ++axis) at[axis][lane] = place(lane)[axis];
    return {hn::Load(f, at[0]), hn::Load(f, at[1]), hn::Load(f, at[2])};
#endif
}

HWY_INLINE Vector3<DoubleLanes> wide(const Vector3<FloatLanes>& v)
{
    const Doubles d;
    return {hn::PromoteTo(d, v.x), hn::PromoteTo(d, v.y), hn::PromoteTo(d, v.z)};
}

/// Finds the hits of all samples of a block, and the sides and planes of its runs.
///
/// runs  all runs of the block
HWY_INLINE void resolve_samples(const TileResolve& tile, std::span<HitRun> runs)
{
    const EyeMesh& mesh = tile.mesh;
    const Doubles d;
    const int block = runs[0].block;
    const LatticeTile rays = tile.items.block_rays(block);
    const std::uint32_t* item = tile.items.item.data() + block * kBlockSamples;
    std::uint64_t covered = 0, open = 0;
    for (const HitRun& run : runs) covered |= run.samples;

    alignas(64) double volume[kBlockSamples];
    alignas(64) glm::vec4 plane[kBlockSamples];
    for (int first = 0; first < kBlockSamples; first += kHitLanes) {
        const std::uint64_t samples = covered >> first & kAllHitLanes;
        if (samples == 0) continue;
        glm::uvec3 index[kHitLanes];
        for (int lane = 0; lane < kHitLanes; ++lane) {
            const std::uint32_t id = item[first + lane];
            index[lane] = mesh.index[id == kNoItem ? runs[0].item : id];
        }
        const auto c0 = fetch_corner(mesh, index, 0), c1 = fetch_corner(mesh, index, 1),
                   c2 = fetch_corner(mesh, index, 2);
        const Vector3<DoubleLanes> v0 = wide(c0), v1 = wide(c1), v2 = wide(c2);
        const Planes<DoubleLanes> p = planes_of_corners(tile, v0, v1, v2);
        hn::Store(p.volume, d, volume + first);
        tile.world.store(p.n, p.volume, plane, first);
        meet({p.n, p.edge[1], p.edge[2], p.volume}, rays, {block, first, samples}, tile);
        open |= (tile.doubtful.find(v0, v1, v2, p.volume) & samples) << first;
    }
    for (HitRun& run : runs) {
        const int sample = std::countr_zero(run.samples);
        run.eye_side = side_of(volume[sample]);
        run.plane = plane[sample];
    }
    if (open == 0) [[likely]]
        return;
    for (HitRun& run : runs)
        if (run.samples & open) settle_run(corners_of(mesh, run.item), tile, rays, run);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
