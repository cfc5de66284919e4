// find_receivers.cpp - finds the hits whose surface faces the light, several triangles at a time.
//
// The results have the same bits as light_side and receiver_of (exact/shadow_ray.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/exact/find_receivers.cpp"
#include "base/simd.h"

#include "shadow/exact/find_receivers.h"
#include "visibility/triangle_planes-inl.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;

constexpr std::size_t kRuns = 64; // of a batch

/// The triangles of some runs, in the light's space.
struct RunBatch {
    alignas(64) float eye_side[kRuns];
    alignas(64) float corner[3][kRuns][4]; // x, y, z, unused
    alignas(64) double volume[kRuns];      // 0 where rounding leaves its sign uncertain
    alignas(64) float receiver[kRuns][4];  // valid if the light is on the eye's side
};

template <class V>
HWY_INLINE V largest_of(const Vector3<V>& v)
{
    return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

void set_up(bool directional, std::size_t count, RunBatch& batch)
{
    const Doubles d;
    const Floats f;
    using V = hn::Vec<Doubles>;
    using F = hn::Vec<Floats>;
    const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        Vector3<F> narrow[3];
        Vector3<V> v[3], pencil[3];
        for (int k = 0; k < 3; ++k) {
            F nothing = hn::Zero(f);
            narrow[k] = {nothing, nothing, nothing};
            hn::LoadInterleaved4(
                f, batch.corner[k][i], narrow[k].x, narrow[k].y, narrow[k].z, nothing);
            v[k] = {hn::PromoteTo(d, narrow[k].x), hn::PromoteTo(d, narrow[k].y),
                hn::PromoteTo(d, narrow[k].z)};
            pencil[k] = v[k];
            if (directional) pencil[k].z = one;
        }
        const V farthest = hn::Max(hn::Max(largest_of(v[0]), largest_of(v[1])), largest_of(v[2]));
        const Vector3<V> m = cross(pencil[1], pencil[2]);
        const V x = hn::Mul(pencil[0].x, m.x), y = hn::Mul(pencil[0].y, m.y),
                z = hn::Mul(pencil[0].z, m.z);
        const V volume = hn::Add(hn::Add(x, y), z);
        const V size = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
        const auto certain = hn::And(hn::Gt(hn::Abs(volume), hn::Mul(hn::Set(d, 8 * kUlp), size)),
            hn::Lt(farthest, hn::Set(d, double(kFarthest))));
        hn::Store(hn::IfThenElseZero(certain, volume), d, batch.volume + i);

        const Vector3<V> n = cross(sub(v[1], v[0]), sub(v[2], v[0]));
        const V largest = largest_of(n);
        const V side = hn::PromoteTo(d, hn::Load(f, batch.eye_side + i));
        const V divisor = hn::Mul(hn::Neg(side), largest);
        const auto plane = hn::Gt(largest, zero);
        const auto away = [&](const V& axis) {
            return hn::DemoteTo(f, hn::IfThenElseZero(plane, hn::Div(axis, divisor)));
        };
        const F corner =
            hn::Max(hn::Max(largest_of(narrow[0]), largest_of(narrow[1])), largest_of(narrow[2]));
        const F margin = hn::Mul(hn::Set(f, kShadowMargin), corner);
        // A triangle without a plane (n = 0) lifts nothing.
        const auto has_plane = hn::Ne(hn::DemoteTo(f, hn::IfThenElseZero(plane, one)), hn::Zero(f));
        hn::StoreInterleaved4(away(n.x), away(n.y), away(n.z),
            hn::IfThenElseZero(has_plane, margin), f, batch.receiver[i]);
    }
}

/// Prefetches the runs, indices and corners of the runs ahead.
HWY_INLINE void prefetch_entries(
    const PencilMesh& mesh, std::span<const HitRun> runs, std::size_t run)
{
    constexpr std::size_t kCorners = 24, kIndex = 64, kRun = 256; // runs ahead
    if (run + kRun < runs.size()) __builtin_prefetch(&runs[run + kRun]);
    if (run + kIndex < runs.size()) __builtin_prefetch(&mesh.index[runs[run + kIndex].item]);
    if (run + kCorners >= runs.size()) return;
    const glm::uvec3& index = mesh.index[runs[run + kCorners].item];
    for (int k = 0; k < 3; ++k) __builtin_prefetch(&mesh.corner[index[k]]);
}

/// Copies a run's corners to index i of the batch. Copies 16 bytes for each 12-byte corner, which
/// is faster; a Buffer has room for that behind its last element.
HWY_INLINE void copy_run(const PencilMesh& mesh, const HitRun& run, std::size_t i, RunBatch& batch)
{
    const glm::uvec3& index = mesh.index[run.item];
    batch.eye_side[i] = run.eye_side;
    for (int k = 0; k < 3; ++k)
        std::memcpy(batch.corner[k][i], static_cast<const void*>(&mesh.corner[index[k]]), 16);
}

void find(const PencilMesh& mesh, const HitTile& hits, TileReceivers& receivers)
{
    RunBatch batch;
    receivers.run.resize(hits.runs.size());
    FacingRun* next = receivers.run.data();
    Effort effort;
    for (std::size_t first = 0; first < hits.runs.size(); first += kRuns) {
        const auto runs = hits.runs.subspan(first, std::min(kRuns, hits.runs.size() - first));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            prefetch_entries(mesh, hits.runs, first + i);
            copy_run(mesh, runs[i], i, batch);
        }
        for (std::size_t i = runs.size(); i % hn::Lanes(Doubles()) != 0; ++i)
            copy_run(mesh, runs[0], i, batch); // fills up the last register
        set_up(mesh.space.directional, runs.size(), batch);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const HitRun& run = runs[i];
            int side = batch.volume[i] > 0 ? 1 : -1;
            if (batch.volume[i] == 0) [[unlikely]]
                side = light_side(mesh.space, mesh.corners(run.item), effort);
            // Written for every run, kept only if it faces the light: a branch would cost more.
            std::memcpy(next->receiver, batch.receiver[i], sizeof next->receiver);
            next->samples = run.samples;
            next->block = run.block;
            next += side == run.eye_side;
        }
    }
    receivers.count = std::size_t(next - receivers.run.data());
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(find);

void find_receivers(const PencilMesh& mesh, const HitTile& hits, TileReceivers& receivers)
{
    HWY_DYNAMIC_DISPATCH(find)(mesh, hits, receivers);
}

} // namespace firsthit
#endif
