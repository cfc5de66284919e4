// resolve_samples-inl.h - hits of a block whose samples mostly have triangles of their own.
//
// Each lane of a register fetches and sets up its own triangle; nothing is kept for a run.
#if defined(FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#undef FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#else
#define FIRSTHIT_HITS_RESOLVE_SAMPLES_INL_H_
#endif

#include "hits/lane_hits-inl.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/scene.h>

#include <span>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

HWY_INLINE Corners corners_of(const ViewMemory& view, std::uint32_t item)
{
    const glm::uvec3 index = view.index[item];
    return {glm::vec3(view.corner[index.x]), glm::vec3(view.corner[index.y]),
        glm::vec3(view.corner[index.z])};
}

/// Corner number `corner` of each lane's triangle.
HWY_INLINE Vector3<FloatLanes> fetch_corner(
    const ViewMemory& view, const glm::uvec3* index, int corner)
{
    const Floats f;
    const auto place = [&](int lane) { return &view.corner[index[lane][corner]].x; };
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    // One or two 4x4 matrices are transposed: of lanes 0 to 3 in the lower half.
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

/// Hits of all samples of a block, and the sides and planes of its runs.
HWY_INLINE void resolve_samples(const ViewMemory& view, const ItemTile& items,
    const WorldPlanes& world, const DoubtfulTriangles& doubtful, std::span<HitRun> runs,
    const HitPlaces& places)
{
    const Doubles d;
    const int block = runs[0].block;
    const LatticeTile rays = items.block_rays(block);
    const std::uint32_t* item = items.item.data() + block * kBlockSamples;
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
            index[lane] = view.index[id == kNoItem ? runs[0].item : id];
        }
        const auto c0 = fetch_corner(view, index, 0), c1 = fetch_corner(view, index, 1),
                   c2 = fetch_corner(view, index, 2);
        const Vector3<DoubleLanes> v0 = wide(c0), v1 = wide(c1), v2 = wide(c2);
        const Planes<DoubleLanes> p = planes_of(v0, v1, v2);
        hn::Store(p.volume, d, volume + first);
        world.store(p.n, p.volume, plane, first);
        meet({p.n, p.edge[1], p.edge[2], p.volume}, rays, block, first, samples, places);
        open |= (doubtful.find(v0, v1, v2, p.volume) & samples) << first;
    }
    for (HitRun& run : runs) {
        const int sample = std::countr_zero(run.samples);
        run.eye_side = side_of(volume[sample]);
        run.plane = plane[sample];
    }
    if (open == 0) [[likely]]
        return;
    for (HitRun& run : runs)
        if (run.samples & open) settle_run(corners_of(view, run.item), world, rays, run, places);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
