// face_samples-inl.h - projects points of a pencil's space to samples of one face, one register of
// points at a time.
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
#include "visibility/stored_depth.h"

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The template argument kAxis of the functions below is the axis of the face, 0 to 2, of a pencil
/// with an origin; kParallel stands for the one face of a parallel pencil.
inline constexpr int kParallel = 3;

/// CubeFace::to_face_axes, but z is not yet multiplied by the face's sign.
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

/// As has_shadow_ray, except that the pencil's origin counts as usable. The origin lies on no face,
/// so on_face and on_wide_face are false for it.
HWY_INLINE truth is_usable(const real3& p)
{
    const auto below = [](real v) { return real(hn::Abs(v.lanes)) < real(kFarthest); };
    return all_of(below(p.x), below(p.y), below(p.z));
}

/// The lanes whose points are in front of the wide face with |x| and |y| up to kWideFaceLimit.
/// Points must be usable.
template <int kAxis>
HWY_INLINE truth on_wide_face(const real3& p, float sign)
{
    const real3 at = face_axes<kAxis>(p);
    const real widest = at.z * real(sign * kWideFaceLimit); // at most 0: the point is not in front
    return all_of(widest > real(0.0f), is_within(at.x, widest), is_within(at.y, widest));
}

/// The lanes whose points have the face's axis and sign as their largest coordinate. Every usable
/// point except the origin lies on exactly one of the six faces.
template <int kAxis>
HWY_INLINE truth on_face(const real3& p, float sign)
{
    const real x(hn::Abs(p.x.lanes)), y(hn::Abs(p.y.lanes)), z(hn::Abs(p.z.lanes));
    const truth ahead = face_axes<kAxis>(p).z * real(sign) > real(0.0f);
    // If two coordinates are equally large, the first one decides.
    if constexpr (kAxis == 0) return all_of(ahead, x >= y, x >= z);
    if constexpr (kAxis == 1) return all_of(ahead, x < y, y >= z);
    return all_of(ahead, x < z, y < z);
}

/// Appends samples of one face to an array and computes their bounds.
class SampleWriter {
  public:
    /// next  the index of the first sample to write. A whole register of samples is written at a
    ///       time: the array must have room for that after the last sample, and entries past next()
    ///       are garbage
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

    /// Projects the chosen lanes and appends them. Where w = 1 / c is not below kGreatestW, the
    /// sample has w = NaN (see IrregularSample) and counts as infinitely far in the bounds.
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

    /// The index after the last sample.
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
