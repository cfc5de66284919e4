// face_samples-inl.h - points in a light's space as samples of one of its faces, a register at a time.
#if defined(FIRSTHIT_IRREGULAR_MESH_FACE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_MESH_FACE_SAMPLES_INL_H_
#undef FIRSTHIT_IRREGULAR_MESH_FACE_SAMPLES_INL_H_
#else
#define FIRSTHIT_IRREGULAR_MESH_FACE_SAMPLES_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "exact/hit.h"
#include "irregular/mesh/cube_face.h"
#include "irregular/mesh/samples.h"
#include "visibility/raster/item_tile.h"

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// What a kernel is made for: the axis of a point light's face, 0 to 2, or all of a directional
/// light.
inline constexpr int kParallel = 3;

/// The coordinates of CubeFace::seen_from, still without the axis' sign.
template <int kAxis>
HWY_INLINE real3 face_axes(const real3& p)
{
    if constexpr (kAxis == 0) return real3(p.y, p.z, p.x);
    if constexpr (kAxis == 1) return real3(p.z, p.x, p.y);
    return p;
}

HWY_INLINE truth all_of(truth a, truth b, truth c)
{
    return {hn::And(hn::And(a.lanes, b.lanes), c.lanes)};
}

HWY_INLINE truth is_within(real a, real limit)
{
    return {hn::Le(hn::Abs(a.lanes), limit.lanes)};
}

/// has_shadow_ray but for the light's own place, which no face sees.
HWY_INLINE truth is_usable(const real3& p)
{
    const auto below = [](real v) { return real(hn::Abs(v.lanes)) < real(kFarthest); };
    return all_of(below(p.x), below(p.y), below(p.z));
}

/// The lanes of usable points that the face sees as the wide one.
template <int kAxis>
HWY_INLINE truth on_wide_face(const real3& p, float sign)
{
    const real3 at = face_axes<kAxis>(p);
    const real widest = at.z * real(sign * kWidestFace); // below 0: behind
    return all_of(widest > real(0.0f), is_within(at.x, widest), is_within(at.y, widest));
}

/// Those whose major axis is the face's. Every usable point but 0 has one face.
template <int kAxis>
HWY_INLINE truth on_face(const real3& p, float sign)
{
    const real x(hn::Abs(p.x.lanes)), y(hn::Abs(p.y.lanes)), z(hn::Abs(p.z.lanes));
    const truth ahead = face_axes<kAxis>(p).z * real(sign) > real(0.0f);
    // Where two are equally large the first is major.
    if constexpr (kAxis == 0) return all_of(ahead, x >= y, x >= z);
    if constexpr (kAxis == 1) return all_of(ahead, x < y, y >= z);
    return all_of(ahead, x < z, y < z);
}

/// Appends samples of a face, and bounds them.
class SampleWriter {
  public:
    /// next  the number of the next one; a register's samples from there on may be written over
    HWY_INLINE SampleWriter(IrregularSample* samples, std::size_t next)
        : samples_(samples),
          next_(next),
          x0_(kInfinite),
          y0_(kInfinite),
          x1_(-kInfinite),
          y1_(-kInfinite),
          farthest_(kInfinite),
          nearest_(-kInfinite)
    {
    }

    /// The chosen lanes.
    template <int kAxis>
    HWY_INLINE void add(
        const real3& p, float sign, hn::Vec<hn::RebindToUnsigned<RealTag>> id, truth chosen)
    {
        const RealTag d;
        const real3 at = face_axes<kAxis>(p);
        const real c = at.z * real(sign);
        real x = at.x, y = at.y, w(hn::Neg(c.lanes)), depth = w;
        if constexpr (kAxis != kParallel) {
            x = at.x / c;
            y = at.y / c;
            w = real(1.0f) / c;
            const truth finite = w < real(kGreatestW);
            w = mix(real(hn::NaN(d)), w, finite);
            depth = mix(real(-kInfinite), w, finite);
        }
        const auto keep = [&](real& bound, auto better) {
            bound = mix(bound, real(better), chosen);
        };
        keep(x0_, hn::Min(x0_.lanes, x.lanes)), keep(x1_, hn::Max(x1_.lanes, x.lanes));
        keep(y0_, hn::Min(y0_.lanes, y.lanes)), keep(y1_, hn::Max(y1_.lanes, y.lanes));
        keep(farthest_, hn::Min(farthest_.lanes, depth.lanes));
        keep(nearest_, hn::Max(nearest_.lanes, depth.lanes));
        auto ids = hn::BitCast(d, id);
        std::size_t count = hn::Lanes(d);
        if (!hn::AllTrue(d, chosen.lanes)) {
            for (real* v : {&x, &y, &w}) v->lanes = hn::Compress(v->lanes, chosen.lanes);
            ids = hn::Compress(ids, chosen.lanes);
            count = hn::CountTrue(d, chosen.lanes);
        }
        hn::StoreInterleaved4(x.lanes, y.lanes, w.lanes, ids, d, &samples_[next_].x);
        next_ += count;
    }

    std::size_t next() const { return next_; }

    HWY_INLINE SampleBounds bounds() const
    {
        const RealTag d;
        const auto lowest = [&](real v) { return hn::GetLane(hn::MinOfLanes(d, v.lanes)); };
        const auto highest = [&](real v) { return hn::GetLane(hn::MaxOfLanes(d, v.lanes)); };
        return {lowest(x0_), lowest(y0_), highest(x1_), highest(y1_), lowest(farthest_),
            highest(nearest_)};
    }

  private:
    static constexpr float kInfinite = std::numeric_limits<float>::infinity();

    IrregularSample* samples_;
    std::size_t next_;
    real x0_, y0_, x1_, y1_, farthest_, nearest_;
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
