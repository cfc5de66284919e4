// shade_block-inl.h - lights the samples of one material in a block.
#if defined(FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#undef FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#else
#define FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#endif

#include "hits/spot_cone.h"
#include "material/models-inl.h"
#include "shade/sample_texture-inl.h"
#include "shade/shade_light.h"
#include "shade/shade_tile.h"

#include <variant>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// What the samples of a tile share.
struct TileShade {
    const HitTile& hits;
    const World& world;
    const ShadeArrays& arrays;
    const ShadeLights& lights;
    const LightVisibility& lit;
    const ShadeTargets& targets;
};

namespace wide {

#include "glsl/hit_position.glsl"
#include "glsl/spot_cone.glsl"

FIRSTHIT_PURE real3 select3(truth choose_a, real3 a, real3 b)
{
    return real3(mix(b.x, a.x, choose_a), mix(b.y, a.y, choose_a), mix(b.z, a.z, choose_a));
}

/// Where the samples of two registers are.
struct SampleLanes {
    std::size_t at;     // of the first sample, in the tile
    std::uint64_t bits; // lanes that are asked for
};

/// The light that the samples send to the eye.
template <class Inputs>
HWY_INLINE real3 light_of(
    const TileShade& tile, const SampleLanes& lanes, const Inputs& inputs, const Surface& surface)
{
    const auto in_no_lane = [&](real share) {
        return (bits_of_truth(share > real(0.0f)) & lanes.bits) == 0;
    };

    real3 color = emitted(inputs, tile.world.scene->ambient);
    for (std::size_t l = 0; l < tile.lights.size(); ++l) {
        ShadeLight spare;
        const ShadeLight& light = tile.lights.at(l, spare);

        // How much of it arrives, and from where.
        const float* lit = tile.lit.of_light(l);
        real share = lit ? load(lit + lanes.at) : real(1.0f);
        if (lit && in_no_lane(share)) continue;
        real3 to_light = all_lanes(light.to_light);
        if (light.kind == Light::Kind::point) {
            to_light = unit(all_lanes(light.position) - surface.position);
        } else if (light.kind == Light::Kind::spot) {
            const real3 d = surface.position - all_lanes(light.position);
            const SpotCone& cone = light.cone;
            share =
                share * cone_share(versine(all_lanes(cone.axis), d), cone.outer, cone.inv_width);
            if (in_no_lane(share)) continue;
            to_light = unit(real3(0.0f, 0.0f, 0.0f) - d);
        }

        const real3 added = reflected(inputs, surface, to_light, all_lanes(light.color));
        if (lit || light.kind == Light::Kind::spot)
            // Lanes without light stay as they are where other lanes have some.
            color = select3(share > real(0.0f), color + added * share, color);
        else
            color = color + added;
    }
    return color;
}

} // namespace wide

/// The samples of a block that some light may reach.
HWY_INLINE std::uint64_t reached_samples(const TileShade& tile, std::uint32_t block)
{
    if (tile.lights.size() == 0) return 0;
    if (!tile.lit.lit) return ~std::uint64_t(0);
    std::uint64_t reached = 0;
    for (std::size_t l = 0; l < tile.lights.size(); ++l) {
        const float* share = tile.lit.of_light(l) + std::size_t(block) * kBlockSamples;
        for (int first = 0; first < kBlockSamples; first += kLanes)
            reached |= bits_of_truth(load(share + first) > real(0.0f)) << first;
    }
    // Of samples without an item the shares are undefined.
    return tile.hits.covered ? reached & tile.hits.covered[block] : reached;
}

/// Writes the geometric normals of all runs of a block.
HWY_NOINLINE void find_geometric(
    const TileShade& tile, std::span<const HitRun> runs, BlockSurface& surface)
{
    for (const HitRun& run : runs)
        spread_geometric(geometric_normal(tile.arrays, run, tile.hits.rays), run, surface);
}

/// Samples of a block that share a material.
struct ShadeGroup {
    std::uint32_t block;
    std::span<const HitRun> runs; // of the block
    std::uint32_t material;
    std::uint64_t samples;
    std::uint64_t reached; // of the block, by some light; the surface has their normals
    bool planes;           // all targets are written, and the surface is complete
};

/// Writes all targets for the group's samples, whose material is a `model`.
template <class Model>
HWY_INLINE void shade_samples(
    const TileShade& tile, const ShadeGroup& group, const Model& model, BlockSurface& of_block)
{
    using wide::both, wide::load, wide::real, wide::real2, wide::real3;
    const ShadeTargets& targets = tile.targets;
    const Scene& scene = *tile.world.scene;
    const bool with_texture = tile.arrays.uv && (targets.color[0] || targets.albedo[0]);
    const Texture* texture =
        with_texture ? texture_of(scene, scene.materials[group.material]) : nullptr;
    const BlockRays rays = block_rays(tile.hits, group.block);
    const real3 right = both(rays.right), down = both(rays.down), forward = both(rays.forward);
    bool has_geometric = group.planes;
    alignas(64) float texture_light[3][kBlockSamples];
    if (texture) sample_texture(*texture, of_block, group.samples, texture_light);

    for (int first = 0; first < kBlockSamples; first += wide::kLanes) {
        const std::uint64_t bits = wide::lane_bits(group.samples, first);
        if (bits == 0) continue;
        const wide::truth chosen = wide::truth_of_bits(bits);
        const bool all = bits == wide::lane_bits(~std::uint64_t(0), 0);
        const std::size_t at = std::size_t(group.block) * kBlockSamples + std::size_t(first);
        const auto write_one = [&](const real& value, float* plane) {
            if (all)
                store(value, plane + at);
            else
                store_where(chosen, value, plane + at);
        };
        const auto write = [&](const real3& value, float* const(&plane)[3]) {
            if (!plane[0]) return;
            write_one(value.x, plane[0]);
            write_one(value.y, plane[1]);
            write_one(value.z, plane[2]);
        };

        real3 texture_color(1.0f, 1.0f, 1.0f);
        if (texture)
            texture_color = real3(load(texture_light[0] + first), load(texture_light[1] + first),
                load(texture_light[2] + first));
        const auto inputs = inputs_of(model, texture_color);
        const std::uint64_t reached =
            kReflects<Model> ? bits & wide::lane_bits(group.reached, first) : 0;
        if (!group.planes && reached == 0) {
            write(emitted(inputs, scene.ambient), targets.color);
            continue;
        }

        wide::Surface surface;
        const real3 direction = wide::ray_direction(real(rays.x0) + load(rays.samples->x + first),
            real(rays.y0) + load(rays.samples->y + first), real(rays.step_x), real(rays.step_y),
            right, down, forward);
        surface.position = wide::hit_position(both(rays.eye), direction, load(tile.hits.t + at));
        surface.to_eye = unit(real3(0.0f, 0.0f, 0.0f) - direction);
        const real3 interpolated(load(of_block.normal[0] + first), load(of_block.normal[1] + first),
            load(of_block.normal[2] + first));
        if (!has_geometric &&
            (reached & ~bits_of_truth(has_direction(bend_to_eye(interpolated, surface.to_eye))))) {
            find_geometric(tile, group.runs, of_block);
            has_geometric = true;
        }
        surface.geometric = real3(load(of_block.geometric[0] + first),
            load(of_block.geometric[1] + first), load(of_block.geometric[2] + first));
        surface.normal = visible_normal(interpolated, surface.geometric, surface.to_eye);
        surface.uv = real2(load(of_block.uv[0] + first), load(of_block.uv[1] + first));

        if (group.planes) {
            write(surface.position, targets.position);
            write(surface.geometric, targets.geometric_normal);
            write(surface.normal, targets.normal);
            write(albedo(inputs), targets.albedo);
            if (targets.uv[0]) {
                write_one(surface.uv.x, targets.uv[0]);
                write_one(surface.uv.y, targets.uv[1]);
            }
        }
        if constexpr (kReflects<Model>) {
            if (targets.color[0])
                write(wide::light_of(tile, {at, bits}, inputs, surface), targets.color);
        } else {
            write(emitted(inputs, scene.ambient), targets.color);
        }
    }
}

/// The same, for whatever model the material is.
HWY_INLINE void shade_samples(
    const TileShade& tile, const ShadeGroup& group, BlockSurface& of_block)
{
    std::visit([&](const auto& model) { shade_samples(tile, group, model, of_block); },
        tile.world.scene->materials[group.material].model);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
