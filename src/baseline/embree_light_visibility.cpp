// embree_light_visibility.cpp - finds which lights reach a tile's hits with Embree's packets of
// shadow rays.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "baseline/embree_light_visibility.cpp"
#include "base/simd.h"

#include "hits/spot_cone-inl.h"
#include "baseline/block_vectors-inl.h"
#include "baseline/embree_packets.h"
#include "baseline/embree_tile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// A packet of shadow rays, from hits to a light.
template <int kRays>
struct LightPackets {
    using Packet = EmbreePacket<kRays>;

    alignas(64) typename Packet::Ray rays;
    alignas(64) int valid[kRays];
    RTCIntersectContext context = coherent_context();
    RTCScene scene;
    float near, far; // ends of a ray, in lengths of its direction

    LightPackets(RTCScene of, float from, float to) : scene(of), near(from), far(to)
    {
        for (int k = 0; k < kRays; ++k) {
            rays.time[k] = 0;
            rays.mask[k] = ~0u;
            rays.id[k] = rays.flags[k] = 0;
            valid[k] = -1;
        }
    }

    /// Shoots the rays of the samples [first, first + kRays) of a block.
    HWY_INLINE void cast(const BlockVectors& origin, const BlockVectors& direction, int first)
    {
        std::memcpy(rays.org_x, origin.x + first, sizeof rays.org_x);
        std::memcpy(rays.org_y, origin.y + first, sizeof rays.org_y);
        std::memcpy(rays.org_z, origin.z + first, sizeof rays.org_z);
        std::memcpy(rays.dir_x, direction.x + first, sizeof rays.dir_x);
        std::memcpy(rays.dir_y, direction.y + first, sizeof rays.dir_y);
        std::memcpy(rays.dir_z, direction.z + first, sizeof rays.dir_z);
        std::fill_n(rays.tnear, kRays, near);
        std::fill_n(rays.tfar, kRays, far);
        Packet::occluded(valid, scene, context, rays);
    }

    /// Stores 1 for each of the last rays that hit nothing, else 0. Embree sets tfar to -infinity
    /// if a ray is occluded.
    HWY_INLINE void store(float* lit) const
    {
        const hn::CappedTag<float, kRays> f;
        for (int k = 0; k < kRays; k += int(hn::Lanes(f))) {
            const auto free = hn::Ge(hn::Load(f, rays.tfar + k), hn::Zero(f));
            hn::Store(hn::IfThenElseZero(free, hn::Set(f, 1.0f)), f, lit + k);
        }
    }
};

/// Collects rays until they fill a packet.
template <int kRays>
struct LooseRays {
    BlockVectors origin, direction; // only the first kRays of each are used
    float* to[kRays];               // where the result of each ray goes
    int count = 0;

    /// Appends the ray of sample `from`, and shoots all rays once they fill a packet.
    HWY_INLINE void add(const BlockVectors& org, const BlockVectors& dir, int from, float* lit,
        LightPackets<kRays>& packets)
    {
        origin.x[count] = org.x[from], origin.y[count] = org.y[from], origin.z[count] = org.z[from];
        direction.x[count] = dir.x[from], direction.y[count] = dir.y[from],
        direction.z[count] = dir.z[from];
        to[count++] = lit;
        if (count == kRays) cast(packets);
    }

    /// Shoots the collected rays.
    void cast(LightPackets<kRays>& packets)
    {
        for (int k = count; k < kRays; ++k) {
            origin.x[k] = origin.x[0], origin.y[k] = origin.y[0], origin.z[k] = origin.z[0];
            direction.x[k] = direction.x[0], direction.y[k] = direction.y[0],
            direction.z[k] = direction.z[0];
            packets.valid[k] = 0;
        }
        packets.cast(origin, direction, 0);
        for (int k = 0; k < count; ++k) *to[k] = packets.rays.tfar[k] >= 0 ? 1.0f : 0.0f;
        std::fill_n(packets.valid, kRays, -1);
        count = 0;
    }
};

/// The bits of the samples [first, first + kLanes) of a block.
HWY_INLINE std::uint64_t bits_from(int first)
{
    return lane_bits(~std::uint64_t(0), 0) << first;
}

/// Finds the visibility of one light.
///
/// facing   (blocks) see EmbreeTileMemory
/// lit      (samples)
/// returns  the number of rays
template <int kRays>
std::uint64_t find_light_visibility_of(RTCScene scene, const HitTile& hits, const Light& light,
    const std::uint64_t* facing, float* lit)
{
    const bool directional = light.kind == Light::Kind::directional;
    const bool spot = light.kind == Light::Kind::spot;
    const SpotCone cone = spot ? spot_cone(light) : SpotCone{};
    const real3 position = from_glm(glm::vec3(light.position));
    const real3 to_sky =
        directional ? from_glm(-glm::vec3(glm::normalize(light.direction))) : position;
    LightPackets<kRays> packets(
        scene, kShadowStart, directional ? std::numeric_limits<float>::infinity() : 1.0f);
    LooseRays<kRays> loose;
    std::uint64_t count = 0;
    constexpr std::uint64_t kAll = (std::uint64_t(1) << kRays) - 1;
    for (std::uint32_t block = 0; block < hits.blocks(); ++block) {
        const std::size_t at = std::size_t(block) * kBlockSamples;
        std::uint64_t chosen = facing[block];
        if (chosen == 0) {
            std::fill_n(lit + at, kBlockSamples, 0.0f);
            continue;
        }
        const BlockRays rays = block_rays(hits, block);
        BlockVectors origin, direction;
        for (int k = 0; k < kBlockSamples; k += kLanes) {
            if (lane_bits(chosen, k) == 0) continue;
            const real3 p =
                hit_position(rays.eye, ray_direction(rays, k), load(hits.t + at + std::size_t(k)));
            origin.set(k, p);
            direction.set(k, directional ? to_sky : position - p);
            if (spot) chosen &= bits_of_truth(in_cone(cone, p - position)) << k | ~bits_from(k);
        }
        count += std::uint64_t(std::popcount(chosen));
        for (int first = 0; first < kBlockSamples; first += kRays) {
            float* const out = lit + at + std::size_t(first);
            std::uint64_t lanes = chosen >> first & kAll;
            if (lanes == kAll) {
                packets.cast(origin, direction, first);
                packets.store(out);
                continue;
            }
            std::fill_n(out, kRays, 0.0f);
            for (; lanes; lanes &= lanes - 1) {
                const int k = std::countr_zero(lanes);
                loose.add(origin, direction, first + k, out + k, packets);
            }
        }
    }
    if (loose.count > 0) loose.cast(packets);
    return count;
}

std::uint64_t find_light_visibility(const EmbreeTile& tile, const HitTile& hits,
    std::span<const Light> lights, const EmbreeTileMemory& memory, float* lit)
{
    const std::size_t samples = std::size_t(hits.size) * std::size_t(hits.size);
    std::uint64_t count = 0;
    for (std::size_t l = 0; l < lights.size(); ++l) {
        const std::uint64_t* facing = memory.facing.data() + l * hits.blocks();
        float* const to = lit + l * samples;
        count += tile.packet == 16
                     ? find_light_visibility_of<16>(tile.scene, hits, lights[l], facing, to)
                     : find_light_visibility_of<8>(tile.scene, hits, lights[l], facing, to);
    }
    return count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(find_light_visibility);

std::uint64_t find_light_visibility_embree(const EmbreeTile& tile, const HitTile& hits,
    std::span<const Light> lights, const EmbreeTileMemory& memory, float* lit)
{
    return HWY_DYNAMIC_DISPATCH(find_light_visibility)(tile, hits, lights, memory, lit);
}

} // namespace firsthit
#endif
