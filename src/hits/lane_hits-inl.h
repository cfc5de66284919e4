// lane_hits-inl.h - where rays meet the planes of their triangles: 1 to 8 samples in a register.
#if defined(FIRSTHIT_HITS_LANE_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_LANE_HITS_INL_H_
#undef FIRSTHIT_HITS_LANE_HITS_INL_H_
#else
#define FIRSTHIT_HITS_LANE_HITS_INL_H_
#endif

#include "hits/block_samples.h"
#include "hits/item_runs-inl.h"
#include "hits/resolve_tile.h"
#include "visibility/raster/set_up-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;
using DoubleLanes = hn::Vec<Doubles>;
using FloatLanes = hn::Vec<Floats>;
inline constexpr int kHitLanes = int(hn::MaxLanes(Doubles()));

/// The triangle of each lane.
struct LanePlanes {
    Vector3<DoubleLanes> n;     // det = n . d
    Vector3<DoubleLanes> edge1; // u = edge1 . d / det
    Vector3<DoubleLanes> edge2;
    DoubleLanes volume; // t = volume / det
    FloatLanes nearest; // depth of its corners, a little widened
    FloatLanes farthest;
};

/// z0, z1, z2: the depths of its corners.
HWY_INLINE LanePlanes lane_planes(const Vector3<DoubleLanes>& n, const Vector3<DoubleLanes>& edge1,
    const Vector3<DoubleLanes>& edge2, DoubleLanes volume, FloatLanes z0, FloatLanes z1,
    FloatLanes z2)
{
    const Floats f;
    return {n, edge1, edge2, volume,
        hn::Mul(hn::Min(z0, hn::Min(z1, z2)), hn::Set(f, 1 - 0x1p-20f)),
        hn::Mul(hn::Max(z0, hn::Max(z1, z2)), hn::Set(f, 1 + 0x1p-20f))};
}

/// From a plane over samples (see Planes) to one in world space.
class WorldPlanes {
  public:
    explicit WorldPlanes(const Pencil& pencil) : axes_(pencil.world_from_axes)
    {
        axes_[0] *= pencil.f;
        axes_[1] *= pencil.f;
    }

    /// HitRun::plane of number i to i + kHitLanes - 1; 0 where the triangle has no area or the eye is in
    /// its plane.
    HWY_INLINE void store(
        const Vector3<DoubleLanes>& n, DoubleLanes volume, glm::vec4* plane, int i) const
    {
        const Doubles d;
        const Floats f;
        const auto axis = [&](int k) {
            return hn::Add(hn::Add(hn::Mul(n.x, hn::Set(d, axes_[0][k])),
                               hn::Mul(n.y, hn::Set(d, axes_[1][k]))),
                hn::Mul(n.z, hn::Set(d, axes_[2][k])));
        };
        const auto x = axis(0), y = axis(1), z = axis(2), zero = hn::Zero(d);
        const auto largest = hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z)));
        const auto inverse = hn::Div(hn::Set(d, 1.0), largest);
        const auto height = hn::Mul(hn::Abs(volume), inverse);
        // No number: false.
        const auto known = hn::And(hn::Gt(height, hn::Set(d, double(kLeastHeight))),
            hn::Lt(height, hn::Set(d, double(kGreatestHeight))));
        // n . (p - eye) = volume.
        const auto side = hn::IfThenElseZero(
            known, hn::IfThenElse(hn::Gt(volume, zero), hn::Neg(inverse), inverse));
        const auto narrow = [&](DoubleLanes v) { return hn::DemoteTo(f, v); };
        hn::StoreInterleaved4(narrow(hn::Mul(x, side)), narrow(hn::Mul(y, side)),
            narrow(hn::Mul(z, side)), narrow(hn::IfThenElseZero(known, height)), f, &plane[i].x);
    }

  private:
    static constexpr float kLeastHeight = 1e-30f, kGreatestHeight = 1e30f; // normal floats
    glm::dmat3 axes_; // columns: of n.x, n.y, n.z
};

/// The rays of one block's samples.
struct BlockOfRays {
    double x0, y0; // of its first sample
    int offset;    // of its first sample, in the tile

    BlockOfRays(const ItemTile& items, int block)
        : x0(double(items.x0) + block % items.blocks_x() * kBlock),
          y0(double(items.y0) + block / items.blocks_x() * kBlock),
          offset(block * kBlockSamples)
    {
    }

    glm::vec3 direction(int sample) const
    {
        return {float(x0 + block_x(sample)), float(y0 + block_y(sample)), 1.0f};
    }
};

/// Writes the hits of the chosen samples, bit k for sample `first` + k. Returns those whose depth
/// lies outside their triangle's.
HWY_INLINE std::uint64_t meet(const LanePlanes& planes, const BlockOfRays& rays, int first,
    std::uint64_t samples, const HitPlaces& places)
{
    const Doubles d;
    const Floats f;
    const auto x =
        hn::Add(hn::Set(d, rays.x0), hn::PromoteTo(d, hn::Load(f, kBlockSamplesXY.x + first)));
    const auto y =
        hn::Add(hn::Set(d, rays.y0), hn::PromoteTo(d, hn::Load(f, kBlockSamplesXY.y + first)));
    const auto at_sample = [&](const Vector3<DoubleLanes>& n) {
        return hn::Add(hn::Add(hn::Mul(n.x, x), hn::Mul(n.y, y)), n.z);
    };
    const auto inverse = hn::Div(hn::Set(d, 1.0), at_sample(planes.n));
    const auto t = hn::DemoteTo(f, hn::Mul(planes.volume, inverse));
    const auto weight = [&](const Vector3<DoubleLanes>& edge) {
        const auto w = hn::DemoteTo(f, hn::Mul(at_sample(edge), inverse));
        return hn::Min(hn::Max(w, hn::Zero(f)), hn::Set(f, 1.0f));
    };
    const auto u = weight(planes.edge1), v = weight(planes.edge2);
    const int at = rays.offset + first;
    if (samples == (std::uint64_t(1) << kHitLanes) - 1) {
        hn::Store(t, f, places.t + at);
        hn::Store(u, f, places.u + at);
        hn::Store(v, f, places.v + at);
    } else {
        std::uint8_t bytes[8];
        std::memcpy(bytes, &samples, 8);
        const auto chosen = hn::LoadMaskBits(f, bytes);
        const auto keep = [&](FloatLanes value, float* to) {
            hn::Store(hn::IfThenElse(chosen, value, hn::Load(f, to)), f, to);
        };
        keep(t, places.t + at);
        keep(u, places.u + at);
        keep(v, places.v + at);
    }
    const auto plausible = hn::And(hn::Ge(t, planes.nearest), hn::Le(t, planes.farthest));
    return samples & ~bits_of(f, plausible);
}

/// A sample whose double depth lies outside the triangle's: its determinant lost too many digits.
HWY_NOINLINE void repair_hit(
    const Corners& corners, const BlockOfRays& rays, int sample, const HitPlaces& places)
{
    const glm::vec3 d = rays.direction(sample);
    const auto [u, v] = exact_barycentrics(corners, d);
    const auto at = std::size_t(rays.offset + sample);
    places.t[at] = float(1 / exact_inverse_depth(corners, d));
    places.u[at] = float(std::clamp(u, 0.0, 1.0));
    places.v[at] = float(std::clamp(v, 0.0, 1.0));
}

/// On which side of its plane a triangle has the eye.
HWY_INLINE std::int16_t side_of(double volume, double volume_size, const auto& corners)
{
    if (std::abs(volume) > 8 * kUlp * volume_size) [[likely]]
        return volume > 0 ? 1 : -1;
    Effort effort;
    return std::int16_t(volume_sign(corners(), effort));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
