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

/// to_light for kLanes points, in place.
HWY_INLINE void move_to_light(const LightSpace& space, float* x, float* y, float* z)
{
    const Wide d;
    const Narrow f;
    for (int k = 0; k < kLanes; k += int(hn::Lanes(d))) {
        const auto from = [&](const float* p, double origin) {
            return hn::Sub(hn::PromoteTo(d, hn::Load(f, p + k)), hn::Set(d, origin));
        };
        const auto px = from(x, space.origin.x), py = from(y, space.origin.y),
                   pz = from(z, space.origin.z);
        const auto store = [&](auto v, float* p) { hn::Store(hn::DemoteTo(f, v), f, p + k); };
        if (!space.directional) {
            store(px, x), store(py, y), store(pz, z);
            continue;
        }
        const auto row = [&](int r) {
            const auto xy = hn::Add(hn::Mul(hn::Set(d, space.axes[0][r]), px),
                hn::Mul(hn::Set(d, space.axes[1][r]), py));
            return hn::Add(xy, hn::Mul(hn::Set(d, space.axes[2][r]), pz));
        };
        store(row(0), x), store(row(1), y), store(row(2), z);
    }
}

void collect(const HitTile& hits, const LightSpace& space, const SpotCone* cone,
    std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk)
{
    const RealTag d;
    const hn::RebindToUnsigned<RealTag> du;
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
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
            store(p.x, x), store(p.y, y), store(p.z, z);
            move_to_light(space, x, y, z);
            if (cone) {
                const std::uint64_t inside =
                    bits_of_truth(in_cone(*cone, real3(load(x), load(y), load(z))));
                chosen[block] &= ~((lanes & ~inside) << first);
                lanes &= inside;
            }
            const auto mask = truth_of_bits(lanes).lanes;
            const auto numbers = hn::RebindMask(du, mask);
            hn::CompressStore(hn::Load(d, x), mask, d, chunk.x.data() + next);
            hn::CompressStore(hn::Load(d, y), mask, d, chunk.y.data() + next);
            hn::CompressStore(hn::Load(d, z), mask, d, chunk.z.data() + next);
            hn::CompressStore(
                hn::Iota(du, first_id + std::uint32_t(at)), numbers, du, chunk.id.data() + next);
            hn::CompressStore(hn::Load(du, hits.item + at), numbers, du, chunk.item.data() + next);
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
