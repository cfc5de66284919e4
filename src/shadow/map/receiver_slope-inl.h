// receiver_slope-inl.h - the receiver slope of each run's triangle, for the slope bias of maps.
#if defined(FIRSTHIT_SHADOW_MAP_RECEIVER_SLOPE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_MAP_RECEIVER_SLOPE_INL_H_
#undef FIRSTHIT_SHADOW_MAP_RECEIVER_SLOPE_INL_H_
#else
#define FIRSTHIT_SHADOW_MAP_RECEIVER_SLOPE_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/known_run.h"
#include "shadow/map/light_frame.h"
#include "visibility/triangle_planes-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Runs whose slopes are computed together.
struct ReceiverSlopeBatch {
    static constexpr int kRuns = 64;
    alignas(64) float normal[3][kRuns]; // HitRun::plane
    alignas(64) float height[kRuns];
    alignas(64) float receiver_slope[kRuns];
};

/// Computes the receiver slope that slope_bias (src/glsl/shadow_map.glsl) needs. It is negative
/// where the light is not on the eye's side of the plane.
/// eye  position of the eye relative to the light
HWY_INLINE void find_receiver_slopes(
    const LightFrame& light, const glm::dvec3& eye, int count, ReceiverSlopeBatch& batch)
{
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    using V = hn::Vec<decltype(d)>;
    const auto set = [&](const glm::dvec3& v) {
        return Vector3<V>{hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
    };
    const auto dot = [](const Vector3<V>& a, const Vector3<V>& b) {
        return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
    };
    const glm::dmat3 rows = glm::transpose(light.axes);
    const Vector3<V> axis_x = set(rows[0]), axis_y = set(rows[1]), axis_z = set(rows[2]);
    const Vector3<V> from_light = set(eye);
    const double largest = std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
    // A light that lies in the plane may seem to be this far above it, because normal and height
    // were rounded to float.
    const V share = hn::Set(d, 0x1p-24), most = hn::Set(d, 1e30);
    const V noise = hn::Set(d, light.parallel ? 0x1p-22 : 0x1p-22 * largest);
    for (int i = 0; i < count; i += int(hn::Lanes(d))) {
        const auto load = [&](const float* p) { return hn::PromoteTo(d, hn::Load(f, p + i)); };
        const Vector3<V> n{load(batch.normal[0]), load(batch.normal[1]), load(batch.normal[2])};
        const V height = load(batch.height);
        const V across = hn::Add(hn::Abs(dot(n, axis_x)), hn::Abs(dot(n, axis_y)));
        const V along = dot(n, axis_z), size = hn::Add(across, hn::Abs(along));
        // Height of the light above the plane. A parallel light shines along its z.
        const V above = light.parallel ? hn::Neg(along) : hn::Sub(height, dot(n, from_light));
        const V least = light.parallel ? noise : hn::Add(noise, hn::Mul(share, hn::Abs(height)));
        const auto seen = hn::Gt(above, least); // false where the plane is not known: all is 0
        const V receiver_slope = hn::Min(hn::Div(size, above), most);
        hn::Store(hn::DemoteTo(f, hn::IfThenElse(seen, receiver_slope, hn::Set(d, -1.0))), f,
            batch.receiver_slope + i);
    }
}

/// Gives samples without an item the slope of a surface that is turned away. Later steps read whole
/// registers and blocks, where undefined values would decide about their neighbours.
HWY_INLINE void turn_misses_away(const HitTile& hits, float* receiver_slope)
{
    const real away(-1.0f);
    for (int block = 0; block < int(hits.blocks()); ++block) {
        if (hits.covered && ~hits.covered[block] == 0) continue;
        for (int first = 0; first < kBlockSamples; first += kLanes)
            store(away, receiver_slope + block * kBlockSamples + first);
    }
}

/// Writes the receiver slope of every sample of the tile.
inline void spread_receiver_slope(
    const HitTile& hits, const World& world, const LightFrame& light, float* receiver_slope)
{
    turn_misses_away(hits, receiver_slope);
    ReceiverSlopeBatch batch = {};
    const glm::dvec3 eye = glm::dvec3(hits.rays.eye) - light.origin;
    for (std::size_t start = 0; start < hits.runs.size(); start += ReceiverSlopeBatch::kRuns) {
        const auto runs = hits.runs.subspan(
            start, std::min<std::size_t>(ReceiverSlopeBatch::kRuns, hits.runs.size() - start));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            HitRun spare;
            const HitRun& run = known_run(runs[i], world, hits.rays, spare);
            for (int axis = 0; axis < 3; ++axis) batch.normal[axis][i] = run.plane[axis];
            batch.height[i] = run.plane.w;
        }
        find_receiver_slopes(light, eye, int(runs.size()), batch);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            float* block = receiver_slope + std::size_t(runs[i].block) * kBlockSamples;
            if ((runs[i].samples & (runs[i].samples - 1)) == 0) {
                block[std::countr_zero(runs[i].samples)] = batch.receiver_slope[i];
                continue;
            }
            const real value(batch.receiver_slope[i]);
            for (int first = 0; first < kBlockSamples; first += kLanes) {
                const std::uint64_t bits = lane_bits(runs[i].samples, first);
                // With wide registers, writing all of the few is faster than mispredicted branches.
                if (kLanes >= 8 || bits != 0)
                    store_where(truth_of_bits(bits), value, block + first);
            }
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
