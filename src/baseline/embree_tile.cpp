// embree_tile.cpp - finds the hits of one tile with Embree's packets of rays from the eye.
//
// The code around the calls of Embree takes a twentieth of their time: it makes rays and stores
// hits a register at a time, and does not write again what is the same for all packets.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "baseline/embree_tile.cpp"
#include "base/simd.h"

#include "hits/item_runs-inl.h"
#include "baseline/block_vectors-inl.h"
#include "baseline/embree_packets.h"
#include "baseline/embree_tile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// Packets of rays from the eye.
template <int kRays>
struct EyePackets {
    using Packet = EmbreePacket<kRays>;

    alignas(64) typename Packet::RayHit rays;
    alignas(64) int valid[kRays];
    RTCIntersectContext context = coherent_context();

    explicit EyePackets(const glm::vec3& eye)
    {
        for (int k = 0; k < kRays; ++k) {
            rays.ray.org_x[k] = eye.x, rays.ray.org_y[k] = eye.y, rays.ray.org_z[k] = eye.z;
            rays.ray.tnear[k] = rays.ray.time[k] = 0;
            rays.ray.mask[k] = ~0u;
            rays.ray.id[k] = rays.ray.flags[k] = 0;
            rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
            valid[k] = -1;
        }
    }

    HWY_INLINE void cast(RTCScene scene, const BlockVectors& direction, int first)
    {
        std::memcpy(rays.ray.dir_x, direction.x + first, sizeof rays.ray.dir_x);
        std::memcpy(rays.ray.dir_y, direction.y + first, sizeof rays.ray.dir_y);
        std::memcpy(rays.ray.dir_z, direction.z + first, sizeof rays.ray.dir_z);
        std::fill_n(rays.ray.tfar, kRays, std::numeric_limits<float>::infinity());
        std::fill_n(rays.hit.geomID, kRays, RTC_INVALID_GEOMETRY_ID);
        Packet::intersect(valid, scene, context, rays);
    }
};

/// Which sides of the triangles of a block are seen.
struct Facing {
    std::uint64_t
        away; // bits of samples whose triangle's normal points away from the eye (volume_sign 1)
    std::span<const LightSide> lights;
    std::uint64_t* light; // EmbreeTileMemory::facing of the block for light 0
    std::size_t stride;   // from one light to the next
    BlockVectors normal;  // of each sample's triangle; not unit vectors
};

/// The items of a register of a packet's rays, from number k on. Embree numbers the triangles of
/// each geometry from 0.
template <int kRays, class D>
HWY_INLINE hn::Vec<D> items_of(const typename EmbreePacket<kRays>::RayHit& rays,
    const std::uint32_t* first_triangle, D n, int k)
{
    const auto item = hn::Load(n, rays.hit.primID + k);
    if (!first_triangle) return item;
    alignas(64) std::uint32_t first[kRays] = {};
    for (int lane = k; lane < k + int(hn::Lanes(n)); ++lane)
        if (const unsigned geometry = rays.hit.geomID[lane]; geometry != RTC_INVALID_GEOMETRY_ID)
            first[lane] = first_triangle[geometry];
    return hn::Add(item, hn::Load(n, first + k));
}

/// The packet of a block whose rays start at sample `first`.
struct PacketPlace {
    std::size_t block_at; // sample 0 of the block, in the tile
    int first;
    const BlockVectors& direction; // of the block's rays
};

/// Stores the hits of a packet, and finds out which sides of their triangles are seen.
///
/// places  of the tile
template <int kRays>
HWY_INLINE void store_hits(const typename EmbreePacket<kRays>::RayHit& rays,
    const std::uint32_t* first_triangle, const PacketPlace& packet, const HitPlaces& places,
    Facing& facing)
{
    const hn::CappedTag<float, kRays> f;
    const hn::RebindToUnsigned<decltype(f)> n;
    const auto& [ray, hit] = rays;
    const auto zero = hn::Zero(f), one = hn::Set(f, 1.0f);
    for (int k = 0; k < kRays; k += int(hn::Lanes(f))) {
        const auto missed =
            hn::Eq(hn::Load(n, hit.geomID + k), hn::Set(n, RTC_INVALID_GEOMETRY_ID));
        const auto none = hn::RebindMask(f, missed);
        const auto item = items_of<kRays>(rays, first_triangle, n, k);
        const std::size_t to = packet.block_at + std::size_t(packet.first + k);
        hn::Store(hn::IfThenElse(missed, hn::Set(n, kNoItem), item), n, places.item + to);
        const auto t = hn::Load(f, ray.tfar + k);
        hn::Store(t, f, places.t + to);
        const auto weight = [&](const float* w) {
            const auto inside = hn::Min(hn::Max(hn::Load(f, w + k), zero), one);
            return hn::IfThenElse(none, zero, inside);
        };
        hn::Store(weight(hit.u), f, places.u + to);
        hn::Store(weight(hit.v), f, places.v + to);

        const auto nx = hn::Load(f, hit.Ng_x + k), ny = hn::Load(f, hit.Ng_y + k),
                   nz = hn::Load(f, hit.Ng_z + k);
        const auto dot = [&](auto x, auto y, auto z) {
            return hn::Add(hn::Add(hn::Mul(nx, x), hn::Mul(ny, y)), hn::Mul(nz, z));
        };
        const int sample = packet.first + k;
        const BlockVectors& direction = packet.direction;
        hn::Store(nx, f, facing.normal.x + sample);
        hn::Store(ny, f, facing.normal.y + sample);
        hn::Store(nz, f, facing.normal.z + sample);
        const auto along = dot(hn::Load(f, direction.x + sample), hn::Load(f, direction.y + sample),
            hn::Load(f, direction.z + sample));
        facing.away |= bits_of(f, hn::AndNot(none, hn::Gt(along, zero))) << sample;
        for (std::size_t l = 0; l < facing.lights.size(); ++l) {
            const LightSide& side = facing.lights[l];
            auto light = dot(hn::Set(f, side.v.x), hn::Set(f, side.v.y), hn::Set(f, side.v.z));
            if (side.near) light = hn::Add(light, hn::Mul(t, along));
            const auto faces = hn::Gt(hn::Mul(light, along), zero);
            facing.light[l * facing.stride] |= bits_of(f, hn::AndNot(none, faces)) << sample;
        }
    }
}

/// Sets the plane of a run from the normal and the ray of one of its samples.
HWY_INLINE void set_plane(
    const BlockVectors& normal, const BlockVectors& direction, float t, int sample, HitRun& run)
{
    const glm::vec3 n(normal.x[sample], normal.y[sample], normal.z[sample]);
    const float largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    const float towards = run.eye_side > 0 ? -1 / largest : 1 / largest;
    const glm::vec3 d(direction.x[sample], direction.y[sample], direction.z[sample]);
    const float height = -t * (glm::dot(n, d) * towards);
    if (!(largest > 1e-30f && height > 1e-30f && height < 1e30f))
        return; // known_run.h computes it later
    run.plane = glm::vec4(n * towards, height);
}

/// Finds the runs of a block and their planes. Returns their number.
std::size_t find_runs(const HitPlaces& places, int block, const Facing& facing,
    const BlockVectors& direction, HitRun* next)
{
    const std::uint32_t* item = places.item + block * kBlockSamples;
    const float* t = places.t + block * kBlockSamples;
    HitRun* const first = next;
    places.covered[block] = ~samples_with(item, kNoItem);
    for (std::uint64_t rest = places.covered[block]; rest;) {
        const int sample = std::countr_zero(rest);
        const std::uint64_t samples = samples_with(item, item[sample]);
        const int side = facing.away >> sample & 1 ? 1 : -1;
        *next = {.item = item[sample],
            .block = std::uint16_t(block),
            .eye_side = std::int16_t(side),
            .samples = samples};
        set_plane(facing.normal, direction, t[sample], sample, *next++);
        rest &= ~samples;
    }
    return std::size_t(next - first);
}

/// Shoots the rays of a tile and stores its hits and runs. Returns the number of runs.
template <int kRays>
std::size_t see_tile(const EmbreeTile& tile, const HitPlaces& places, EmbreeTileMemory& memory)
{
    HitTile hits;
    hits.size = tile.size;
    hits.rays = tile.rays;
    const int blocks_x = tile.size / kBlock, blocks = blocks_x * blocks_x;
    EyePackets<kRays> packets(tile.rays.eye);
    std::size_t runs = 0;
    for (int block = 0; block < blocks; ++block) {
        const BlockRays rays = block_rays(hits, std::uint32_t(block));
        BlockVectors direction;
        for (int k = 0; k < kBlockSamples; k += kLanes) direction.set(k, ray_direction(rays, k));
        const int left = tile.width - block % blocks_x * kBlock,
                  above = tile.height - block / blocks_x * kBlock;
        const bool whole = left >= kBlock && above >= kBlock;
        Facing facing;
        facing.away = 0;
        facing.lights = memory.side.span();
        facing.light = memory.facing.data() + block;
        facing.stride = std::size_t(blocks);
        const std::size_t at = std::size_t(block) * kBlockSamples;
        for (int first = 0; first < kBlockSamples; first += kRays) {
            for (int k = 0; !whole && k < kRays; ++k)
                packets.valid[k] = block_x(first + k) < left && block_y(first + k) < above ? -1 : 0;
            packets.cast(tile.scene, direction, first);
            store_hits<kRays>(
                packets.rays, tile.first_triangle, {at, first, direction}, places, facing);
        }
        if (!whole) std::fill_n(packets.valid, kRays, -1);
        runs += find_runs(places, block, facing, direction, places.run + runs);
    }
    return runs;
}

std::size_t see(const EmbreeTile& tile, const HitPlaces& places, EmbreeTileMemory& memory)
{
    return tile.packet == 16 ? see_tile<16>(tile, places, memory)
                             : see_tile<8>(tile, places, memory);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {
namespace {

LightSide side_of(const Light& light, const glm::vec3& eye)
{
    if (light.kind == Light::Kind::directional)
        return {glm::vec3(glm::normalize(light.direction)), false};
    return {eye - glm::vec3(light.position), true};
}

} // namespace

HWY_EXPORT(see);

HitTile see_embree(const EmbreeTile& tile, const HitPlaces& places, std::span<const Light> lights,
    EmbreeTileMemory& memory)
{
    memory.side.resize(lights.size());
    for (std::size_t l = 0; l < lights.size(); ++l)
        memory.side[l] = side_of(lights[l], tile.rays.eye);
    const std::size_t blocks = std::size_t(tile.size / kBlock) * std::size_t(tile.size / kBlock);
    memory.facing.resize(lights.size() * blocks);
    std::fill_n(memory.facing.data(), memory.facing.size(), std::uint64_t(0));
    const std::size_t runs = HWY_DYNAMIC_DISPATCH(see)(tile, places, memory);
    HitTile hits;
    hits.size = tile.size;
    hits.rays = tile.rays;
    hits.runs = std::span<const HitRun>(places.run, runs);
    hits.covered = places.covered;
    hits.item = places.item;
    hits.t = places.t;
    hits.u = places.u;
    hits.v = places.v;
    return hits;
}

} // namespace firsthit
#endif
