// shade_block-inl.h - computes the colours of the samples of one material in a block.
#if defined(FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#undef FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#else
#define FIRSTHIT_SHADE_SHADE_BLOCK_INL_H_
#endif

#include "hits/spot_cone.h"
#include "material/models-inl.h"
#include "shade/sample_environment-inl.h"
#include "shade/sample_maps-inl.h"
#include "shade/shade_light.h"
#include "shade/shade_tile.h"
#include "shade/sky_light-inl.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <variant>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// What all samples of a tile share.
struct TileShade {
    const HitTile& hits;
    const World& world;
    const ShadeArrays& arrays;
    const ShadeLights& lights;
    const LightVisibility& lit;
    const ShadeTargets& targets;
    bool planes;                         // whether any target but colour is asked for
    const ShadeEnvironment& environment; // without texels where no material reflects it
    bool softens; // whether shadows of flat triangles meet smooth normals: see terminator_share
};

namespace wide {

#include "glsl/falloff.glsl"
#include "glsl/hit_position.glsl"
#include "glsl/spot_cone.glsl"

FIRSTHIT_PURE real3 select3(truth choose_a, real3 a, real3 b)
{
    return real3(mix(b.x, a.x, choose_a), mix(b.y, a.y, choose_a), mix(b.z, a.z, choose_a));
}

/// The ambient light that a model sees: none where it reflects the environment.
template <class Model>
HWY_INLINE vec3 ambient_of(const TileShade& tile)
{
    return kReflectsEnvironment<Model> && tile.environment.any() ? vec3(0.0f)
                                                                 : tile.world.scene->ambient;
}

/// The samples of two registers (base/wide_real-inl.h).
struct SampleLanes {
    std::size_t at;     // index of the first sample in the tile
    std::uint64_t bits; // the lanes to shade
};

/// The light that the samples send to the eye: what the material emits, plus what it reflects of
/// the environment and of each light.
template <class Model, class Inputs>
HWY_INLINE real3 light_of(
    const TileShade& tile, const SampleLanes& lanes, const Inputs& inputs, const Surface& surface)
{
    const auto in_no_lane = [&](real share) {
        return (bits_of_truth(share > real(0.0f)) & lanes.bits) == 0;
    };

    real3 color = emitted(inputs, ambient_of<Model>(tile));
    SkyLight sky;
    if (tile.lit.sky.rays)
        sky = sky_light_of(tile.lit.sky,
            {lanes.at / kBlockSamples, static_cast<int>(lanes.at % kBlockSamples)}, surface.normal);
    const bool surrounded_too = kReflectsEnvironment<Model> && tile.environment.any();
    if constexpr (kReflectsEnvironment<Model>)
        if (surrounded_too) {
            AroundLight around = around_light(
                {&tile.environment}, surface.normal, surface.to_eye, roughness(inputs));
            if (tile.lit.sky.rays) around.diffuse = around.diffuse * sky.openness;
            color = color + surrounded(inputs, around);
        }
    if (tile.lit.sky.rays && !surrounded_too) color = color + scattered(inputs, sky.light);
    for (std::size_t l = 0; l < tile.lights.size(); ++l) {
        ShadeLight spare;
        const ShadeLight& light = tile.lights.at(l, spare);

        // Find the share of the light that arrives, and the direction to the light.
        const float* lit = tile.lit.of_light(l);
        real share = lit ? load(lit + lanes.at) : real(1.0f);
        if (lit && in_no_lane(share)) continue;
        const bool fades = light.inv_range2 >= 0;
        real3 to_light = all_lanes(light.to_light);
        if (light.kind == Light::Kind::point) {
            const real3 d = all_lanes(light.position) - surface.position;
            to_light = unit(d);
            if (fades) share = share * inverse_square(dot(d, d), light.inv_range2);
        } else if (light.kind == Light::Kind::spot) {
            const real3 d = surface.position - all_lanes(light.position);
            const SpotCone& cone = light.cone;
            const real versed = versine(all_lanes(cone.axis), d);
            if (fades)
                share = share * (squared_cone_share(versed, cone.outer, cone.inv_width) *
                                    inverse_square(dot(d, d), light.inv_range2));
            else
                share = share * cone_share(versed, cone.outer, cone.inv_width);
            if (in_no_lane(share)) continue;
            to_light = unit(real3(0.0f, 0.0f, 0.0f) - d);
        }

        if (lit && tile.softens) share = share * terminator_share(surface, to_light);
        const real3 added = reflected(inputs, surface, to_light, all_lanes(light.color));
        if (lit || fades || light.kind == Light::Kind::spot)
            // Lanes that the light does not reach keep their colour.
            color = select3(share > real(0.0f), color + added * share, color);
        else
            color = color + added;
    }
    return color;
}

} // namespace wide

/// The bits of the block's samples that at least one light, the environment or the sky may reach.
HWY_INLINE std::uint64_t reached_samples(const TileShade& tile, std::uint32_t block)
{
    if (tile.environment.any() || tile.lit.sky.rays) return ~std::uint64_t(0);
    if (tile.lights.size() == 0) return 0;
    if (!tile.lit.lit) return ~std::uint64_t(0);
    std::uint64_t reached = 0;
    for (std::size_t l = 0; l < tile.lights.size(); ++l) {
        const float* share = tile.lit.of_light(l) + std::size_t(block) * kBlockSamples;
        for (int first = 0; first < kBlockSamples; first += kLanes)
            reached |= bits_of_truth(load(share + first) > real(0.0f)) << first;
    }
    // The shares of samples without an item are undefined.
    return tile.hits.covered ? reached & tile.hits.covered[block] : reached;
}

/// Writes the geometric normals of all runs of a block.
HWY_NOINLINE void find_geometric(
    const TileShade& tile, std::span<const HitRun> runs, BlockAttributes& attributes)
{
    for (const HitRun& run : runs)
        spread_geometric(geometric_normal(tile.arrays, run, tile.hits.rays), run, attributes);
}

/// Writes which way the runs of a block face. The world has normals.
HWY_NOINLINE void find_facing(
    const TileShade& tile, std::span<const HitRun> runs, BlockAttributes& attributes)
{
    for (const HitRun& run : runs) {
        HitRun spare;
        const HitRun& known = known_run(run, tile.world, tile.hits.rays, spare);
        const RunFacing facing =
            run_facing(tile.arrays, tile.arrays.scene->index[run.item], glm::vec3(known.plane));
        static_assert(sizeof facing == sizeof attributes.facing[0]);
        for (std::uint64_t rest = run.samples; rest; rest &= rest - 1)
            std::memcpy(attributes.facing[std::countr_zero(rest)], &facing, sizeof facing);
    }
}

/// Loads which way the samples from `first` on face.
HWY_INLINE void load_facing(const BlockAttributes& attributes, int first, wide::Surface& surface)
{
    const auto load = [&](int from, real3& normal, real& bend) {
        hn::LoadInterleaved4(RealTag(), attributes.facing[from], normal.x.lanes, normal.y.lanes,
            normal.z.lanes, bend.lanes);
    };
    real3 low, high;
    real low_bend, high_bend;
    load(first, low, low_bend);
    load(first + kLanes, high, high_bend);
    surface.flat_normal = wide::real3(
        wide::real(low.x, high.x), wide::real(low.y, high.y), wide::real(low.z, high.z));
    surface.bend = wide::real(low_bend, high_bend);
}

/// Whether a light may be fading out towards some of the samples.
HWY_INLINE bool near_terminator(
    const TileShade& tile, std::uint64_t samples, const wide::real3& normal)
{
    for (std::size_t l = 0; l < tile.lights.size(); ++l) {
        ShadeLight spare;
        const ShadeLight& light = tile.lights.at(l, spare);
        if (light.kind != Light::Kind::directional) return true;
        const wide::real n_l = dot(normal, wide::all_lanes(light.to_light));
        if (samples & ~wide::bits_of_truth(n_l >= wide::real(wide::kSurelyLit))) return true;
    }
    return false;
}

/// The samples of a block that have the same material.
struct ShadeGroup {
    std::uint32_t block;
    std::span<const HitRun> runs; // all runs of the block
    std::uint32_t material;
    std::uint64_t samples;
    std::uint64_t reached; // samples of the block that a light may reach; their normals are known
    bool planes;           // all targets are written, so all attributes are known
};

/// Writes all targets for the group's samples. `model` is the model of their material.
template <class Model>
HWY_INLINE void shade_samples(
    const TileShade& tile, const ShadeGroup& group, const Model& model, BlockAttributes& attributes)
{
    using wide::both, wide::load, wide::real, wide::real2, wide::real3;
    const ShadeTargets& targets = tile.targets;
    const Scene& scene = *tile.world.scene;
    constexpr std::size_t kMaps = kMapsOf<Model>.size();
    constexpr int kNormalMap = normal_map(kMapsOf<Model>);
    const Texture* texture = nullptr;
    if constexpr (kMaps == 0)
        if (tile.arrays.uv && (targets.color[0] || targets.albedo[0]))
            texture = texture_of(scene, scene.materials[group.material]);
    const BlockRays rays = block_rays(tile.hits, group.block);
    const real3 right = both(rays.right), down = both(rays.down), forward = both(rays.forward);
    bool has_geometric = group.planes, has_facing = false;
    alignas(64) float texture_light[3][kBlockSamples];
    if (texture) sample_texture(*texture, attributes, group.samples, texture_light);
    [[maybe_unused]] BlockMaps<std::max<std::size_t>(kMaps, 1)> sampled;
    if constexpr (kMaps > 0) sample_maps(tile.arrays, model, attributes, group.samples, sampled);
    const bool colored = tile.arrays.color != nullptr;

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
        const auto load3 = [&](const float(&plane)[3][kBlockSamples]) {
            return real3(load(plane[0] + first), load(plane[1] + first), load(plane[2] + first));
        };
        wide::MapColors maps;
        if constexpr (kMaps == 0) {
            if (colored) texture_color = texture_color * load3(attributes.color);
        } else {
            for (std::size_t k = 0; k < kMaps; ++k) {
                const auto* const light = sampled.map[k];
                maps.map[k] = {real3(1.0f, 1.0f, 1.0f), real(1.0f)};
                if (light)
                    maps.map[k] = {real3(load(light[0] + first), load(light[1] + first),
                                       load(light[2] + first)),
                        has_alpha(kMapsOf<Model>[k]) ? load(light[3] + first) : real(1.0f)};
            }
            if (colored) maps.map[0].rgb = maps.map[0].rgb * load3(attributes.color);
        }
        const auto inputs = [&] {
            if constexpr (kMaps == 0)
                return inputs_of(model, texture_color);
            else
                return inputs_of(model, maps);
        }();
        const std::uint64_t reached =
            kReflects<Model> ? bits & wide::lane_bits(group.reached, first) : 0;
        if (!group.planes && reached == 0) {
            write(emitted(inputs, wide::ambient_of<Model>(tile)), targets.color);
            continue;
        }

        wide::Surface surface;
        const real3 offset = wide::ray_offset(real(rays.x0) + load(kBlockSamplesXY.x + first),
            real(rays.y0) + load(kBlockSamplesXY.y + first), real(rays.step_x), real(rays.step_y),
            right, down);
        const real3 direction = rays.parallel ? forward : offset + forward;
        const real3 start = rays.parallel ? both(rays.eye) + offset : both(rays.eye);
        surface.position = wide::hit_position(start, direction, load(tile.hits.t + at));
        surface.to_eye = unit(real3(0.0f, 0.0f, 0.0f) - direction);
        real3 interpolated = load3(attributes.normal);
        if constexpr (kNormalMap >= 0)
            if (sampled.map[kNormalMap] && tile.arrays.tangent)
                interpolated = mapped_normal(interpolated, load3(attributes.tangent),
                    load(attributes.side + first), maps.map[kNormalMap].rgb, model.normal_scale);
        if (!has_geometric &&
            (reached & ~bits_of_truth(has_direction(bend_to_eye(interpolated, surface.to_eye))))) {
            find_geometric(tile, group.runs, attributes);
            has_geometric = true;
        }
        surface.geometric = load3(attributes.geometric);
        surface.normal = visible_normal(interpolated, surface.geometric, surface.to_eye);
        if (tile.softens && reached && near_terminator(tile, reached, surface.normal)) {
            if (!has_facing) find_facing(tile, group.runs, attributes);
            has_facing = true;
        }
        surface.flat_normal = real3(0.0f, 0.0f, 0.0f);
        surface.bend = real(0.0f);
        if (has_facing) load_facing(attributes, first, surface);
        surface.uv = real2(load(attributes.uv[0] + first), load(attributes.uv[1] + first));

        if (group.planes) {
            write(surface.position, targets.position);
            write(surface.geometric, targets.geometric_normal);
            write(surface.normal, targets.normal);
            write(albedo(inputs), targets.albedo);
            if constexpr (kReflectsEnvironment<Model>) {
                write(emission(inputs), targets.emission);
                if (targets.metallic_roughness[0]) {
                    write_one(metallic(inputs), targets.metallic_roughness[0]);
                    write_one(roughness(inputs), targets.metallic_roughness[1]);
                }
            } else {
                write(real3(0.0f, 0.0f, 0.0f), targets.emission);
                for (float* const plane : targets.metallic_roughness)
                    if (plane) write_one(real(0.0f), plane);
            }
            if (targets.uv[0]) {
                write_one(surface.uv.x, targets.uv[0]);
                write_one(surface.uv.y, targets.uv[1]);
            }
        }
        if constexpr (kReflects<Model>) {
            if (targets.color[0])
                write(wide::light_of<Model>(tile, {at, bits}, inputs, surface), targets.color);
        } else {
            write(emitted(inputs, wide::ambient_of<Model>(tile)), targets.color);
        }
    }
}

/// The same for a material of any model.
HWY_INLINE void shade_samples(
    const TileShade& tile, const ShadeGroup& group, BlockAttributes& attributes)
{
    std::visit([&](const auto& model) { shade_samples(tile, group, model, attributes); },
        tile.world.scene->materials[group.material].model);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
