// hit_hull-inl.h - bounds of the hits of a block or tile: their depths, and eight points around.
#if defined(FIRSTHIT_SHADOW_HIT_HULL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_HIT_HULL_INL_H_
#undef FIRSTHIT_SHADOW_HIT_HULL_INL_H_
#else
#define FIRSTHIT_SHADOW_HIT_HULL_INL_H_
#endif

#include "shadow/map/ray_transform-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The nearest and farthest depth of some samples, and how many of them have a hit.
struct HitDepths {
    float nearest, farthest;
    std::size_t hits;
};

/// The same, accumulated lane by lane.
struct LaneDepths {
    real nearest, farthest;
    std::size_t hits = 0;

    HWY_INLINE LaneDepths() : nearest(std::numeric_limits<float>::infinity()), farthest(0.0f) {}

    /// samples  a multiple of kLanes
    HWY_INLINE void add(const float* t, int samples)
    {
        for (int first = 0; first < samples; first += kLanes) {
            const real depth = load(t + first);
            const truth hit = depth < real(std::numeric_limits<float>::infinity());
            nearest = min(nearest, depth);
            farthest = max(farthest, mix(real(0.0f), depth, hit));
            hits += hn::CountTrue(RealTag(), hit.lanes);
        }
    }

    HWY_INLINE HitDepths over_lanes() const
    {
        return {hn::GetLane(hn::MinOfLanes(RealTag(), nearest.lanes)),
            hn::GetLane(hn::MaxOfLanes(RealTag(), farthest.lanes)), hits};
    }
};

HWY_INLINE HitDepths block_depths(const float* t)
{
    LaneDepths depths;
    depths.add(t, kBlockSamples);
    return depths.over_lanes();
}

HWY_INLINE HitDepths tile_depths(const HitTile& hits)
{
    LaneDepths depths;
    for (int block = 0; block < int(hits.blocks()); ++block)
        if (!hits.is_empty(block)) depths.add(hits.t + block * kBlockSamples, kBlockSamples);
    return depths.over_lanes();
}

/// The hits of a square of samples lie in the convex hull of eight points: the square's four corner
/// rays at its nearest and at its farthest depth. Points are repeated to fill wider registers.
struct HitHull {
    static constexpr int kRegisters = std::max(1, 8 / kLanes);
    real3 p[kRegisters];
};

/// The hull of the `side` x `side` samples whose first is (x, y) of the tile, in the space that
/// `to` transforms into.
HWY_INLINE HitHull hit_hull(const Rays& to, float x, float y, int side, const HitDepths& depths)
{
    alignas(64) static constexpr float kX[16] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
    alignas(64) static constexpr float kY[16] = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    alignas(64) static constexpr float kFar[16] = {0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1};
    const real last(float(side - 1));
    HitHull hull;
    for (int k = 0; k < HitHull::kRegisters; ++k) {
        const real t =
            mix(real(depths.nearest), real(depths.farthest), load(kFar + k * kLanes) > real(0.5f));
        hull.p[k] = transform_points(to, real(to.x0 + x) + last * load(kX + k * kLanes),
            real(to.y0 + y) + last * load(kY + k * kLanes), t);
    }
    return hull;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
