// collect_hits.cpp - from the hits of a tile to points in a light's space.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/collect_hits.cpp"
#include "base/simd.h"

#include "hits/hit_position-inl.h"
#include "hits/spot_cone-inl.h"
#include "shadow/collect_hits.h"
#include "shadow/to_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// lifted (exact/shadow_ray.h), the same bits.
HWY_INLINE real3 lifted(
    const LightSpace& space, real3 d, const TileReceivers& receivers, std::size_t at)
{
    const RealTag f;
    const auto size = [](real v) { return real(hn::Abs(v.lanes)); };
    const real largest(hn::Max(hn::Max(size(d.x).lanes, size(d.y).lanes), size(d.z).lanes));
    const real margin = real(kShadowMargin) * (real(2.0f) * largest + real(space.reach));
    const real height(
        hn::Mul(hn::Set(f, 0.5f), (margin + load(receivers.margin.data() + at)).lanes));
    return d + real3(load(receivers.x.data() + at), load(receivers.y.data() + at),
                   load(receivers.z.data() + at)) *
                   height;
}

void collect(const HitTile& hits, const TileReceivers& receivers, const LightSpace& space,
    const SpotCone* cone, std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk)
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
            real3 q = to_light(space, p);
            if (cone) {
                const std::uint64_t inside = bits_of_truth(in_cone(*cone, q));
                chosen[block] &= ~((lanes & ~inside) << first);
                lanes &= inside;
            }
            q = lifted(space, q, receivers, at);
            const auto mask = truth_of_bits(lanes).lanes;
            const auto numbers = hn::RebindMask(du, mask);
            // Whole registers, of which the next ones write over what is too much: some processors
            // are very slow to compress straight to memory.
            const auto keep = [&](real v, Buffer<float>& to) {
                hn::StoreU(hn::Compress(v.lanes, mask), d, to.data() + next);
            };
            keep(q.x, chunk.x), keep(q.y, chunk.y), keep(q.z, chunk.z);
            hn::StoreU(hn::Compress(hn::Iota(du, first_id + std::uint32_t(at)), numbers), du,
                chunk.id.data() + next);
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

void collect_hits(const HitTile& hits, const TileReceivers& receivers, const LightSpace& space,
    const SpotCone* cone, std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk)
{
    HWY_DYNAMIC_DISPATCH(collect)(hits, receivers, space, cone, first_id, chosen, chunk);
}

void unpack_bits(std::span<const std::uint64_t> words, float* floats)
{
    HWY_DYNAMIC_DISPATCH(unpack)(words, floats);
}

} // namespace firsthit
#endif
