// lane_hits-inl.h - intersects rays with the planes of their triangles, 1 to 8 samples in a
// register.
#if defined(FIRSTHIT_HITS_LANE_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_LANE_HITS_INL_H_
#undef FIRSTHIT_HITS_LANE_HITS_INL_H_
#else
#define FIRSTHIT_HITS_LANE_HITS_INL_H_
#endif

#include "exact/careful_hit.h"
#include "hits/block_samples.h"
#include "hits/item_runs-inl.h"
#include "hits/resolve_tile.h"
#include "visibility/triangle_planes-inl.h"

#include <algorithm>
#include <bit>
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
inline constexpr std::uint64_t kAllHitLanes = (std::uint64_t(1) << kHitLanes) - 1;

/// The planes of each lane's triangle; d is the direction of the lane's ray.
struct LanePlanes {
    Vector3<DoubleLanes> n;     // det = n . d
    Vector3<DoubleLanes> edge1; // u = edge1 . d / det
    Vector3<DoubleLanes> edge2; // v = edge2 . d / det
    DoubleLanes volume;         // t = volume / det
};

/// Finds doubtful triangles: those for which the computation in double might lose more digits than
/// float has, or might find the wrong side of the eye. Their runs need settle_run.
///
/// Let R be the largest |X| or |Y| of the tile's directions, or 1, and let z be multiplied by R.
/// Let E^2 =
/// |v1 - v0|^2 + |v2 - v0|^2 and M^2 = |v0|^2 + E^2. The terms of det sum up to at most E^2
/// (exact/careful_hit.h, Plain), those of edge1 and edge2 to 2 E M, and those of volume to 3.5 E
/// M^2 / R. For rays that hit, det = volume / t and t <= 1.5 M / R. So nothing is lost if |volume|
/// R > 3.5 2^-24 E M^2. The test uses 2^-21 instead. That makes its own roundings unimportant, and
/// also that R differs from tile to tile, since settle_run changes nothing that is precise enough.
class DoubtfulTriangles {
  public:
    explicit DoubtfulTriangles(const TileItems& items)
    {
        const glm::dvec2 most = items.rays.reach(items.size, items.size);
        const double reach = std::max({1.0, most.x, most.y});
        reach2_ = reach * reach;
    }

    /// Returns a bit for each lane, which is set if its triangle is doubtful.
    HWY_INLINE std::uint64_t find(const Vector3<DoubleLanes>& v0, const Vector3<DoubleLanes>& v1,
        const Vector3<DoubleLanes>& v2, DoubleLanes volume) const
    {
        const Doubles d;
        const auto e1 = sub(v1, v0), e2 = sub(v2, v0);
        const auto reach2 = hn::Set(d, reach2_);
        const auto flat2 = [](const Vector3<DoubleLanes>& v) {
            return hn::MulAdd(v.x, v.x, hn::Mul(v.y, v.y));
        };
        const auto e_z2 = hn::MulAdd(e1.z, e1.z, hn::Mul(e2.z, e2.z));
        const auto e_2 = hn::MulAdd(reach2, e_z2, hn::Add(flat2(e1), flat2(e2)));
        const auto m_2 = hn::Add(hn::MulAdd(reach2, hn::Mul(v0.z, v0.z), flat2(v0)), e_2);
        const auto large = hn::Gt(hn::Mul(hn::Mul(volume, volume), hn::Set(d, reach2_ * 0x1p42)),
            hn::Mul(hn::Mul(m_2, m_2), e_2));
        return kAllHitLanes & ~bits_of(d, large);
    }

  private:
    double reach2_;
};

/// Transforms planes from eye space (see Planes) to world space. Those of parallel rays stay unknown.
class WorldPlanes {
  public:
    explicit WorldPlanes(const Pencil& pencil)
        : axes_(glm::transpose(pencil.eye_from_world)),
          parallel_(pencil.parallel)
    {
    }

    /// Stores HitRun::plane of a register of triangles to plane[i] to plane[i + kHitLanes - 1]. It
    /// is 0 if the triangle has no area or the eye is in its plane.
    HWY_INLINE void store(
        const Vector3<DoubleLanes>& n, DoubleLanes volume, glm::vec4* plane, int i) const
    {
        const Doubles d;
        const Floats f;
        if (parallel_) {
            std::fill_n(plane + i, kHitLanes, glm::vec4(0));
            return;
        }
        const auto axis = [&](int k) {
            return hn::Add(hn::Add(hn::Mul(n.x, hn::Set(d, axes_[0][k])),
                               hn::Mul(n.y, hn::Set(d, axes_[1][k]))),
                hn::Mul(n.z, hn::Set(d, axes_[2][k])));
        };
        const auto x = axis(0), y = axis(1), z = axis(2), zero = hn::Zero(d);
        const auto largest = hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z)));
        const auto inverse = hn::Div(hn::Set(d, 1.0), largest);
        const auto height = hn::Mul(hn::Abs(volume), inverse);
        // This is false for NaN.
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
    glm::dmat3 axes_; // columns: the world vectors that n.x, n.y and n.z multiply
    bool parallel_;
};

/// What the hits of a tile are found from, and where they go.
struct TileResolve {
    const EyeMesh& mesh;
    const Pencil& pencil;
    const TileItems& items;
    const WorldPlanes& world;
    const DoubtfulTriangles& doubtful;
    const HitPlaces& places;
};

/// The planes of each lane's triangle, whose corners are v0, v1 and v2. The space of parallel rays
/// (Pencil::parallel) has weights of its own: a corner's weight in the world is proportional to that one
/// times the corner's z there. So the planes of the weights are multiplied by it.
HWY_INLINE Planes<DoubleLanes> planes_of_corners(const TileResolve& tile,
    const Vector3<DoubleLanes>& v0, const Vector3<DoubleLanes>& v1, const Vector3<DoubleLanes>& v2)
{
    Planes<DoubleLanes> p = planes_of(v0, v1, v2);
    if (tile.pencil.parallel) {
        const auto scale = [](Vector3<DoubleLanes>& n, DoubleLanes z) {
            n = {hn::Mul(n.x, z), hn::Mul(n.y, z), hn::Mul(n.z, z)};
        };
        scale(p.edge[1], v1.z);
        scale(p.edge[2], v2.z);
    }
    return p;
}

/// Some samples of one register of a block.
struct RegisterSamples {
    int block;
    int first;             // number in the block of the register's first sample
    std::uint64_t samples; // bit k: sample first + k is meant
};

/// Writes the hits of the samples.
///
/// rays  of the block's samples
HWY_INLINE void meet(const LanePlanes& planes, const LatticeTile& rays,
    const RegisterSamples& lanes, const TileResolve& tile)
{
    const HitPlaces& places = tile.places;
    const Pencil& pencil = tile.pencil;
    const int first = lanes.first;
    const std::uint64_t samples = lanes.samples;
    const Doubles d;
    const Floats f;
    // The sums are exact in float, as all directions are.
    const auto along = [&](float start, const float* offsets) {
        return hn::PromoteTo(d, hn::Add(hn::Set(f, start), hn::Load(f, offsets + first)));
    };
    const auto x = along(rays.x0, kBlockSamplesXY.x), y = along(rays.y0, kBlockSamplesXY.y);
    const auto at_sample = [&](const Vector3<DoubleLanes>& n) {
        return hn::Add(hn::Add(hn::Mul(n.x, x), hn::Mul(n.y, y)), n.z);
    };
    // The depth 1 / s of parallel rays is det / volume, and the weights are edges / volume.
    const auto det = at_sample(planes.n);
    const auto inverse = hn::Div(hn::Set(d, 1.0), pencil.parallel ? planes.volume : det);
    auto depth = hn::Mul(planes.volume, inverse);
    if (pencil.parallel)
        depth = hn::Sub(
            hn::Set(d, pencil.far), hn::Mul(hn::Set(d, pencil.scale), hn::Mul(det, inverse)));
    const auto t = hn::DemoteTo(f, depth);
    const auto weight = [&](const Vector3<DoubleLanes>& edge) {
        const auto w = hn::DemoteTo(f, hn::Mul(at_sample(edge), inverse));
        return hn::Min(hn::Max(w, hn::Zero(f)), hn::Set(f, 1.0f));
    };
    const auto u = weight(planes.edge1), v = weight(planes.edge2);
    const int at = lanes.block * kBlockSamples + first;
    if (samples == kAllHitLanes) {
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
}

/// Corrects the hits, the eye's side and the plane of a run whose triangle is doubtful.
///
/// rays  of the run's block
HWY_NOINLINE void settle_run(
    const Corners& corners, const TileResolve& tile, const LatticeTile& rays, HitRun& run)
{
    const HitPlaces& places = tile.places;
    const Pencil& pencil = tile.pencil;
    const CarefulHit careful(corners);
    run.eye_side = std::int16_t(careful.eye_side());
    const Doubles d;
    alignas(64) glm::vec4 plane[kHitLanes];
    const glm::dvec3& n = careful.n();
    tile.world.store({hn::Set(d, n.x), hn::Set(d, n.y), hn::Set(d, n.z)},
        hn::Set(d, careful.volume()), plane, 0);
    run.plane = plane[0];
    for (std::uint64_t rest = run.samples; rest; rest &= rest - 1) {
        const int sample = std::countr_zero(rest);
        const glm::vec3 direction = rays.direction(block_x(sample), block_y(sample));
        const auto at = std::size_t(run.block * kBlockSamples + sample);
        const CarefulHit::Plain plain = careful.plain(direction);
        const double depth = careful.depth(direction);
        if (!plain.depth)
            places.t[at] = float(pencil.parallel ? pencil.parallel_depth(depth) : depth);
        if (plain.weights && (plain.depth || !pencil.parallel)) continue;
        auto [u, v] = careful.weights(direction);
        if (pencil.parallel) u *= double(corners[1].z) / depth, v *= double(corners[2].z) / depth;
        places.u[at] = float(std::clamp(u, 0.0, 1.0));
        places.v[at] = float(std::clamp(v, 0.0, 1.0));
    }
}

/// HitRun::eye_side of a triangle that is not doubtful.
///
/// volume  see Planes
HWY_INLINE std::int16_t side_of(double volume)
{
    return volume > 0 ? 1 : -1;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
