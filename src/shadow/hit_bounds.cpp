// hit_bounds.cpp - the part of a light's projection that visible hits fill.
#include "shadow/hit_bounds.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/hit_bounds.cpp"
#include "base/simd.h"

#include "shadow/ray_transform-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// Bounds lane by lane.
struct LaneBounds {
    real x0, y0, x1, y1;
    std::uint64_t hits;

    // Written out: the compiler's own would not be compiled for the target.
    HWY_INLINE LaneBounds()
        : x0(FaceBounds::kInfinity),
          y0(FaceBounds::kInfinity),
          x1(-FaceBounds::kInfinity),
          y1(-FaceBounds::kInfinity),
          hits(0)
    {
    }

    HWY_INLINE void add(truth chosen, real x, real y)
    {
        x0 = min(x0, mix(real(FaceBounds::kInfinity), x, chosen));
        y0 = min(y0, mix(real(FaceBounds::kInfinity), y, chosen));
        x1 = max(x1, mix(real(-FaceBounds::kInfinity), x, chosen));
        y1 = max(y1, mix(real(-FaceBounds::kInfinity), y, chosen));
        hits += std::uint64_t(hn::CountTrue(RealTag(), chosen.lanes));
    }

    FaceBounds over_lanes() const
    {
        const RealTag d;
        return {hn::GetLane(hn::MinOfLanes(d, x0.lanes)), hn::GetLane(hn::MinOfLanes(d, y0.lanes)),
            hn::GetLane(hn::MaxOfLanes(d, x1.lanes)), hn::GetLane(hn::MaxOfLanes(d, y1.lanes)),
            hits};
    }
};

HWY_INLINE void add_on_face(int face, truth chosen, real3 p, LaneBounds& bounds)
{
    if (!any(chosen)) return;
    const real c[3] = {p.x, p.y, p.z};
    const FaceAxes axes = face_axes(face);
    const real inv_z = real(axes.backwards ? -1.0f : 1.0f) / c[axes.z];
    bounds.add(chosen, c[axes.x] * inv_z, c[axes.y] * inv_z);
}

void add_tile(const HitTile& hits, const LightFrame& light, LightBounds& total)
{
    const RayTransform to = ray_transform(hits.frame, light.axes, light.origin, glm::dvec3(0));
    const real infinity(FaceBounds::kInfinity);
    const float tan2_cone = float(light.tan2_cone);
    LaneBounds bounds[kFaces];
    const int blocks_x = hits.size / kBlock;
    for (int block = 0; block < blocks_x * blocks_x; ++block) {
        const float x = float(block % blocks_x * kBlock), y = float(block / blocks_x * kBlock);
        for (int first = 0; first < kBlockSamples; first += kLanes) {
            const real t = load(hits.t + block * kBlockSamples + first);
            truth chosen = t < infinity;
            if (!any(chosen)) continue;
            const real3 p = transform_hits(to, x, y, first, t);
            chosen = chosen & has_shadow_ray(p, light.parallel);
            if (light.tan2_cone > 0) chosen = chosen & in_cone(p, tan2_cone);
            if (light.parallel) {
                bounds[kOnlyFace].add(chosen, p.x, p.y);
            } else if (!light.cube) {
                add_on_face(kOnlyFace, chosen, p, bounds[kOnlyFace]);
            } else {
                const OnFaces on = on_faces(p);
                add_on_face(0, chosen & on.of(0), p, bounds[0]);
                add_on_face(1, chosen & on.of(1), p, bounds[1]);
                add_on_face(2, chosen & on.of(2), p, bounds[2]);
                add_on_face(3, chosen & on.of(3), p, bounds[3]);
                add_on_face(4, chosen & on.of(4), p, bounds[4]);
                add_on_face(5, chosen & on.of(5), p, bounds[5]);
            }
        }
    }
    for (int face = 0; face < kFaces; ++face)
        total[std::size_t(face)].add(bounds[face].over_lanes());
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(add_tile);

void FaceBounds::add(const FaceBounds& other)
{
    x0 = std::min(x0, other.x0);
    y0 = std::min(y0, other.y0);
    x1 = std::max(x1, other.x1);
    y1 = std::max(y1, other.y1);
    hits += other.hits;
}

void add_hits(const HitTile& hits, const LightFrame& light, LightBounds& bounds)
{
    HWY_DYNAMIC_DISPATCH(add_tile)(hits, light, bounds);
}

} // namespace firsthit
#endif
