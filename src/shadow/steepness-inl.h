// steepness-inl.h - how steeply a light sees each run's triangle, and from which side.
#if defined(FIRSTHIT_SHADOW_STEEPNESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_STEEPNESS_INL_H_
#undef FIRSTHIT_SHADOW_STEEPNESS_INL_H_
#else
#define FIRSTHIT_SHADOW_STEEPNESS_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "hits/hit_tile.h"
#include "shadow/light_frame.h"
#include "visibility/set_up-inl.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Runs that are worked out together.
struct SteepnessBatch {
    static constexpr int kRuns = 64;
    alignas(64) float corner[9][kRuns];
    alignas(64) float steepness[kRuns];
};

/// Steepness as texel_epsilon (src/glsl/shadow_map.glsl) takes it, below 0 where the light is not on
/// the side of the plane that the eye is on, in double: tiny triangles have tiny normals.
HWY_INLINE void find_steepness(
    const LightFrame& light, const glm::dvec3& eye, int count, SteepnessBatch& batch)
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
    const Vector3<V> eye_at = set(eye), light_at = set(light.origin);
    for (int i = 0; i < count; i += int(hn::Lanes(d))) {
        const auto load = [&](int k) { return hn::PromoteTo(d, hn::Load(f, batch.corner[k] + i)); };
        const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
            v2{load(6), load(7), load(8)};
        const Vector3<V> n = cross(sub(v1, v0), sub(v2, v0));
        const V across = hn::Add(hn::Abs(dot(n, axis_x)), hn::Abs(dot(n, axis_y)));
        const V along = dot(n, axis_z), size = hn::Add(across, hn::Abs(along));
        const V to_light = light.parallel ? along : dot(n, sub(v0, light_at));
        const V to_eye = dot(n, sub(v0, eye_at));
        const auto seen = hn::Gt(hn::Mul(to_light, to_eye), hn::Zero(d));
        // A triangle without area gives 0 / 0, which is not seen.
        const V steepness = hn::Min(hn::Div(size, hn::Abs(to_light)), hn::Set(d, 1e30));
        hn::Store(hn::DemoteTo(f, hn::IfThenElse(seen, steepness, hn::Set(d, -1.0))), f,
            batch.steepness + i);
    }
}

/// Asks for the memory of runs that come soon: first their indices, then their corners.
HWY_INLINE void prefetch_runs(const HitTile& hits, const World& world, std::size_t run)
{
    constexpr std::size_t kIndices = 24, kCorners = 12; // runs ahead
    if (run + kIndices < hits.runs.size())
        hwy::Prefetch(&world.scene->index[hits.runs[run + kIndices].item]);
    if (run + kCorners < hits.runs.size()) {
        const glm::uvec3& corner = world.scene->index[hits.runs[run + kCorners].item];
        for (int k = 0; k < 3; ++k) hwy::Prefetch(&world.position[corner[k]]);
    }
}

/// Writes the steepness of all runs' samples.
inline void spread_steepness(
    const HitTile& hits, const World& world, const LightFrame& light, float* steepness)
{
    SteepnessBatch batch;
    const glm::dvec3 eye(hits.frame.eye);
    for (std::size_t start = 0; start < hits.runs.size(); start += SteepnessBatch::kRuns) {
        const auto runs = hits.runs.subspan(
            start, std::min<std::size_t>(SteepnessBatch::kRuns, hits.runs.size() - start));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            prefetch_runs(hits, world, start + i);
            const glm::uvec3& corner = world.scene->index[runs[i].item];
            for (int k = 0; k < 3; ++k) {
                const glm::vec3& p = world.position[corner[k]];
                batch.corner[3 * k][i] = p.x;
                batch.corner[3 * k + 1][i] = p.y;
                batch.corner[3 * k + 2][i] = p.z;
            }
        }
        find_steepness(light, eye, int(runs.size()), batch);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const real value(batch.steepness[i]);
            float* block = steepness + std::size_t(runs[i].block) * kBlockSamples;
            for (int first = 0; first < kBlockSamples; first += kLanes) {
                const std::uint64_t bits = lane_bits(runs[i].samples, first);
                // Wide registers are few: to write them all is faster than to guess which.
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
