// collect_hits.cpp - from the hits of a tile to points in a light's space.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/collect_hits.cpp"
#include "base/simd.h"

#include "hits/hit_position-inl.h"
#include "hits/spot_cone-inl.h"
#include "shadow/collect_hits.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Wide = hn::CappedTag<double, 8>;
using Narrow = hn::Rebind<float, Wide>;

/// to_light (exact/shadow_ray.h), the same bits.
HWY_INLINE real3 to_light(const LightSpace& space, real3 p)
{
    if (!space.directional) return p - from_glm(space.origin);
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
    store(p.x, x), store(p.y, y), store(p.z, z);
    const Wide d;
    const Narrow f;
    for (int k = 0; k < kLanes; k += int(hn::Lanes(d))) {
        const auto wide = [&](const float* v) { return hn::PromoteTo(d, hn::Load(f, v + k)); };
        const auto px = wide(x), py = wide(y), pz = wide(z);
        const auto row = [&](int r, float* to) {
            const auto xy = hn::Add(hn::Mul(hn::Set(d, space.axes[0][r]), px),
                hn::Mul(hn::Set(d, space.axes[1][r]), py));
            const auto sum = hn::Add(xy, hn::Mul(hn::Set(d, space.axes[2][r]), pz));
            hn::Store(hn::DemoteTo(f, sum), f, to + k);
        };
        row(0, x), row(1, y), row(2, z);
    }
    return real3(load(x), load(y), load(z));
}

void collect(const HitTile& hits, const LightSpace& space, const SpotCone* cone,
    std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk)
{
    const RealTag d;
    const hn::RebindToUnsigned<RealTag> du;
    std::size_t next = 0;
    const std::uint32_t blocks =
        std::uint32_t(hits.size / kBlock) * std::uint32_t(hits.size / kBlock);
    for (std::uint32_t block = 0; block < blocks; ++block) {
        if (chosen[block] == 0) continue;
        const BlockRays rays = block_rays(hits, block);
        for (int first = 0; first < kBlockSamples; first += kLanes) {
            std::uint64_t lanes = lane_bits(chosen[block], first);
            if (lanes == 0) continue;
            const std::size_t at = std::size_t(block) * kBlockSamples + std::size_t(first);
            const real3 p = hit_position(rays.eye, ray_direction(rays, first), load(hits.t + at));
            const real3 q = to_light(space, p);
            if (cone) {
                const std::uint64_t inside = bits_of_truth(in_cone(*cone, q));
                chosen[block] &= ~((lanes & ~inside) << first);
                lanes &= inside;
            }
            const auto mask = truth_of_bits(lanes).lanes;
            const auto numbers = hn::RebindMask(du, mask);
            hn::CompressStore(q.x.lanes, mask, d, chunk.x.data() + next);
            hn::CompressStore(q.y.lanes, mask, d, chunk.y.data() + next);
            hn::CompressStore(q.z.lanes, mask, d, chunk.z.data() + next);
            hn::CompressStore(
                hn::Iota(du, first_id + std::uint32_t(at)), numbers, du, chunk.id.data() + next);
            next += hn::CountTrue(d, mask);
        }
    }
    chunk.count = next;
}

void unpack(std::span<const std::uint64_t> words, float* floats)
{
    for (const std::uint64_t word : words)
        for (int first = 0; first < kBlockSamples; first += kLanes, floats += kLanes)
            store(mix(real(0.0f), real(1.0f), truth_of_bits(lane_bits(word, first))), floats);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(collect);
HWY_EXPORT(unpack);

void collect_hits(const HitTile& hits, const LightSpace& space, const SpotCone* cone,
    std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk)
{
    HWY_DYNAMIC_DISPATCH(collect)(hits, space, cone, first_id, chosen, chunk);
}

void unpack_bits(std::span<const std::uint64_t> words, float* floats)
{
    HWY_DYNAMIC_DISPATCH(unpack)(words, floats);
}

} // namespace firsthit
#endif
