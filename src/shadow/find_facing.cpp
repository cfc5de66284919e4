// find_facing.cpp - which hits have the light on the side of their surface that the eye sees?
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/find_facing.cpp"
#include "base/simd.h"

#include "shadow/find_facing.h"
#include "visibility/set_up-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;

constexpr std::size_t kRuns = 64; // together

/// Corners of runs' items in the light's space, and the volumes that say which side the light sees.
struct SideBatch {
    alignas(64) float corner[9][kRuns];
    alignas(64) double volume[kRuns]; // 0 where its sign is not certain
};

void find_volumes(bool directional, std::size_t count, SideBatch& batch)
{
    const Doubles d;
    const Floats f;
    using V = hn::Vec<Doubles>;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto load = [&](int axis) {
            return hn::PromoteTo(d, hn::Load(f, batch.corner[axis] + i));
        };
        const V one = hn::Set(d, 1.0);
        const auto corner = [&](int k) {
            return Vector3<V>{load(3 * k), load(3 * k + 1), directional ? one : load(3 * k + 2)};
        };
        const Vector3<V> v0 = corner(0), n = cross(corner(1), corner(2));
        const V x = hn::Mul(v0.x, n.x), y = hn::Mul(v0.y, n.y), z = hn::Mul(v0.z, n.z);
        const V volume = hn::Add(hn::Add(x, y), z);
        const V size = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
        const auto certain = hn::Gt(hn::Abs(volume), hn::Mul(hn::Set(d, 8 * kUlp), size));
        hn::Store(hn::IfThenElseZero(certain, volume), d, batch.volume + i);
    }
}

void facing(const LightMesh& mesh, const HitTile& hits, std::span<std::uint64_t> words)
{
    std::fill(words.begin(), words.end(), std::uint64_t(0));
    const bool directional = mesh.space.directional;
    SideBatch batch{};
    Effort effort;
    for (std::size_t first = 0; first < hits.runs.size(); first += kRuns) {
        const auto runs = hits.runs.subspan(first, std::min(kRuns, hits.runs.size() - first));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const glm::uvec3& index = mesh.index[runs[i].item];
            for (int k = 0; k < 3; ++k) {
                const glm::vec3& p = mesh.corner[index[k]];
                for (int axis = 0; axis < 3; ++axis) batch.corner[3 * k + axis][i] = p[axis];
            }
        }
        find_volumes(directional, runs.size(), batch);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const HitRun& run = runs[i];
            int side = batch.volume[i] > 0 ? 1 : -1;
            if (batch.volume[i] == 0) [[unlikely]]
                side = light_side(mesh.space, mesh.corners(run.item), effort);
            if (side == run.eye_side) words[run.block] |= run.samples;
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(facing);

void find_facing(const LightMesh& mesh, const HitTile& hits, std::span<std::uint64_t> words)
{
    HWY_DYNAMIC_DISPATCH(facing)(mesh, hits, words);
}

} // namespace firsthit
#endif
