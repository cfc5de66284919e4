// hit_bounds.cpp - bounds of the visible hits on the faces of a light.
#include "shadow/map/hit_bounds.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/map/hit_bounds.cpp"
#include "base/simd.h"

#include "shadow/hit_hull-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// FaceBounds, accumulated lane by lane.
struct LaneBounds {
    real x0, y0, x1, y1;
    std::uint64_t hits;

    // Not defaulted, because an implicit constructor is not compiled for the SIMD target.
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

/// Adds a register of hits one by one.
HWY_INLINE void add_points(
    const LightFrame& light, truth chosen, real3 p, LaneBounds (&bounds)[kFaces])
{
    const auto add_face = [&](int face, truth on) {
        bounds[face].hits += hn::CountTrue(RealTag(), on.lanes);
        add_on_face(face, on, p, bounds[face]);
    };
    chosen = chosen & has_shadow_ray(p, light.parallel);
    if (light.tan2_cone > 0) chosen = chosen & in_cone(p, float(light.tan2_cone));
    if (light.parallel) {
        bounds[kOnlyFace].add(chosen, p.x, p.y);
        bounds[kOnlyFace].hits += hn::CountTrue(RealTag(), chosen.lanes);
    } else if (!light.cube) {
        add_face(kOnlyFace, chosen);
    } else {
        const OnFaces on = on_faces(p);
        for (int face = 0; face < kFaces; ++face) add_face(face, chosen & on.of(face));
    }
}

/// If all eight points of the hull of a block's hits lie on one face, so do the hits: adds the
/// points as bounds of the hits. Else adds nothing and returns false.
///
/// hits  their number
HWY_INLINE bool add_hull(
    const LightFrame& light, const HitHull& hull, std::size_t hits, LaneBounds (&bounds)[kFaces])
{
    constexpr int kRegisters = HitHull::kRegisters;
    const real3(&p)[kRegisters] = hull.p;
    truth reached[kRegisters];
    for (int k = 0; k < kRegisters; ++k) {
        reached[k] = has_shadow_ray(p[k], light.parallel);
        if (!all(reached[k])) return false;
    }
    if (light.parallel) {
        for (int k = 0; k < kRegisters; ++k) bounds[kOnlyFace].add(reached[k], p[k].x, p[k].y);
        bounds[kOnlyFace].hits += hits;
        return true;
    }
    const auto add_face = [&](int face) {
        for (int k = 0; k < kRegisters; ++k)
            if (!all(on_faces(p[k]).of(face))) return false;
        for (int k = 0; k < kRegisters; ++k) add_on_face(face, reached[k], p[k], bounds[face]);
        bounds[face].hits += hits;
        return true;
    };
    return add_face(0) || add_face(1) || add_face(2) || add_face(3) || add_face(4) || add_face(5);
}

void add_tile(const HitTile& hits, const LightFrame& light, LightBounds& total)
{
    const Rays to = transformed(hits.rays, light.axes, light.origin, glm::dvec3(0));
    const real infinity(FaceBounds::kInfinity);
    const bool cone = light.tan2_cone > 0;
    LaneBounds bounds[kFaces];
    const int blocks_x = hits.size / kBlock;
    for (int block = 0; block < blocks_x * blocks_x; ++block) {
        if (hits.is_empty(block)) continue;
        const float x = float(block % blocks_x * kBlock), y = float(block / blocks_x * kBlock);
        const float* block_t = hits.t + block * kBlockSamples;
        if (!cone) {
            const HitDepths depths = block_depths(block_t);
            if (depths.hits == 0) continue;
            if (add_hull(light, hit_hull(to, x, y, kBlock, depths), depths.hits, bounds)) continue;
        }
        for (int first = 0; first < kBlockSamples; first += kLanes) {
            const real t = load(block_t + first);
            const truth hit = t < infinity;
            if (any(hit)) add_points(light, hit, transform_hits(to, x, y, first, t), bounds);
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
