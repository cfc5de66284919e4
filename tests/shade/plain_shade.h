// plain_shade.h - shades one sample after the other from the same formulas; kernels must give equal
// results.
#pragma once

#include "exact/shadow_ray.h"
#include "hits/hit_position.h"
#include "hits/known_run.h"
#include "hits/spot_cone.h"
#include "material/models.h"
#include "shade/run_setup.h"
#include "shade/shade_environment.h"
#include "shade/shade_light.h"
#include "shade/shade_tile.h"

#include <array>
#include <variant>

namespace firsthit {
namespace scalar {

#include "glsl/falloff.glsl"
#include "glsl/power.glsl"
#include "glsl/texture.glsl"

using glm::vec3;

FIRSTHIT_PURE real3 all_lanes(const vec3& v)
{
    return {v.x, v.y, v.z};
}

FIRSTHIT_PURE real3 real_of(const glm::dvec3& v)
{
    return {float(v.x), float(v.y), float(v.z)};
}

#include "material/texts.inl"

/// What environment.glsl looks up in.
struct EnvironmentTables {
    const ShadeEnvironment* shade;
};

inline vec3 diffuse_term(EnvironmentTables tables, int k)
{
    return tables.shade->diffuse[k];
}

inline real level_side(EnvironmentTables tables, real level)
{
    return tables.shade->side[std::size_t(level)];
}

inline real level_first(EnvironmentTables tables, real level)
{
    return tables.shade->first[std::size_t(level)];
}

inline real table_first(EnvironmentTables tables)
{
    return tables.shade->table;
}

inline real3 weighted_light(
    EnvironmentTables tables, integer top, integer bottom, FourWeights weights)
{
    const auto texel = [&](integer k) {
        const float* const at = tables.shade->texel + 4 * k;
        return real3(at[0], at[1], at[2]);
    };
    return ((texel(top) * weights.top_left + texel(top + 1) * weights.top_right) +
               texel(bottom) * weights.bottom_left) +
           texel(bottom + 1) * weights.bottom_right;
}

inline real environment_strength(EnvironmentTables tables)
{
    return tables.shade->strength;
}

inline real3 turned_back(real3 d, float cosine, float sine);

inline real3 environment_space(EnvironmentTables tables, real3 d)
{
    return turned_back(d, tables.shade->cosine, tables.shade->sine);
}

#include "glsl/environment.glsl"

inline real2 from_glm(const glm::vec2& v)
{
    return {v.x, v.y};
}

/// Adds the weighted texels of a level, 0 to -32768.
inline void add_level(const Texture& texture, int level, real right, real down, integer weight,
    std::array<integer, 4>& sum)
{
    const auto width = static_cast<float>(texture.width(level));
    const auto height = static_cast<float>(texture.height(level));
    const Texels at = texture.sampler().nearest ? nearest_texels(right, down, width, height)
                                                : bilinear_texels(right, down, width, height);
    const TexelWeights weights = texel_weights(at, weight);
    const auto row = texture.texels().subspan(std::size_t(texture.first()[std::size_t(level)]));
    const auto add = [&](integer index, integer share) {
        for (std::size_t c = 0; c < 4; ++c) sum[c] += share * row[std::size_t(index)][c];
    };
    add(at.top, weights.top_left);
    add(at.top + 1, weights.top_right);
    add(at.bottom, weights.bottom_left);
    add(at.bottom + 1, weights.bottom_right);
}

inline MapColor sample_texture(const Texture& texture, real u, real v, real length2)
{
    const Sampler& sampler = texture.sampler();
    const real last = sampler.nearest ? 0.0f : static_cast<float>(texture.levels() - 1);
    const real right = wrapped(u, int(sampler.wrap_u));
    const real down = 1.0f - wrapped(v, int(sampler.wrap_v));
    const real level = mip_level(length2, last);
    const real finer = floor(level);
    const integer coarse = whole_to_integer((level - finer) * 32767.0f);
    std::array<integer, 4> sum{};
    add_level(texture, static_cast<int>(finer), right, down, whole_weight() - coarse, sum);
    if (coarse > 0) add_level(texture, static_cast<int>(finer) + 1, right, down, coarse, sum);
    return {{texel_light(sum[0]), texel_light(sum[1]), texel_light(sum[2])}, texel_light(sum[3])};
}

/// Of one map.
inline MapColor sample_map(const ShadeArrays& arrays, const TextureRef& map, const HitRun& run,
    const Rays& rays, real t, real u, real v)
{
    const Texture* const texture = texture_of(arrays, map);
    if (!texture) return {{1, 1, 1}, 1};
    const RunPlane plane = run_plane(arrays, run.item, rays);
    const Interpolated<glm::vec2> uv =
        map.uv_set == 0 ? run_uv(arrays, plane.corner) : run_uv1(arrays, plane.corner);
    const RunGradients g = run_gradients(plane, uv, rays);
    const real2 less = from_glm(uv.to1) * u + from_glm(uv.to2) * v;
    const real2 step_u(
        texture_step(less.x, t, g.u.x, g.one.x), texture_step(less.x, t, g.u.y, g.one.y));
    const real2 step_v(
        texture_step(less.y, t, g.v.x, g.one.x), texture_step(less.y, t, g.v.y, g.one.y));
    const real2 at = from_glm(uv.at0) + less;
    const glm::mat3x2& m = map.transform;
    return sample_texture(*texture, (m[0].x * at.x + m[1].x * at.y) + m[2].x,
        (m[0].y * at.x + m[1].y * at.y) + m[2].y,
        moved_footprint2(step_u, step_v, from_glm(m[0]), from_glm(m[1]),
            real2(static_cast<float>(texture->width()), static_cast<float>(texture->height()))));
}

template <class Model>
inline void shade_sample(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets, const HitRun& run, int sample, const Material& material,
    const Model& model)
{
    const Scene& scene = *world.scene;
    const ShadeArrays arrays = shade_arrays(world);
    const RunPlane run_plane = firsthit::run_plane(arrays, run.item, hits.rays);
    const Interpolated<glm::vec3> run_normals =
        run_normal(arrays, run_plane.corner, glm::vec3(with_plane(run, world, hits.rays).plane));
    const Interpolated<glm::vec2> run_uvs = run_uv(arrays, run_plane.corner);
    const std::size_t at = std::size_t(run.block) * kBlockSamples + std::size_t(sample);
    const real t = hits.t[at], u = hits.u[at], v = hits.v[at];
    const auto write = [&](float* const(&plane)[3], const real3& value) {
        if (!plane[0]) return;
        plane[0][at] = value.x;
        plane[1][at] = value.y;
        plane[2][at] = value.z;
    };

    const int blocks_x = hits.size / kBlock;
    const int x = static_cast<int>(run.block) % blocks_x * kBlock + block_x(sample);
    const int y = static_cast<int>(run.block) / blocks_x * kBlock + block_y(sample);
    const real3 direction = ray_direction(hits.rays, static_cast<float>(x), static_cast<float>(y));
    Surface surface;
    surface.position = hit_position(from_glm(hits.rays.eye), direction, t);
    surface.geometric = from_glm(geometric_normal(arrays, run, hits.rays));
    surface.to_eye = unit(real3(0, 0, 0) - direction);
    HitRun spare;
    RunFacing facing;
    if (arrays.normal)
        facing = run_facing(
            arrays, run_plane.corner, glm::vec3(known_run(run, world, hits.rays, spare).plane));
    surface.flat_normal = from_glm(facing.normal);
    surface.bend = facing.bend;
    const auto at_hit = [&](const Interpolated<glm::vec3>& of) {
        return from_glm(of.at0) + (from_glm(of.to1) * u + from_glm(of.to2) * v);
    };
    real3 normal = at_hit(run_normals);
    const real2 less_corner = from_glm(run_uvs.to1) * u + from_glm(run_uvs.to2) * v;
    const real2 uv = surface.uv = from_glm(run_uvs.at0) + less_corner;

    const real3 of_vertices =
        arrays.color ? at_hit(run_color(arrays, run_plane.corner)) : real3(1, 1, 1);
    const auto inputs = [&] {
        if constexpr (kMapsOf<Model>.empty()) {
            real3 color_of_texture(1, 1, 1);
            if (const Texture* texture = arrays.uv ? texture_of(scene, material) : nullptr) {
                const real2 size(
                    static_cast<float>(texture->width()), static_cast<float>(texture->height()));
                const RunGradients gradients = run_gradients(run_plane, run_uvs, hits.rays);
                color_of_texture = sample_texture(*texture, uv.x, uv.y,
                    footprint2(less_corner.x, less_corner.y, t, from_glm(gradients.u),
                        from_glm(gradients.v), from_glm(gradients.one), size))
                                       .rgb;
            }
            return inputs_of(model, color_of_texture * of_vertices);
        } else {
            MapColors maps;
            for (std::size_t k = 0; k < kMapsOf<Model>.size(); ++k)
                maps.map[k] =
                    sample_map(arrays, map_of(model, kMapsOf<Model>[k]), run, hits.rays, t, u, v);
            maps.map[0].rgb = maps.map[0].rgb * of_vertices;
            if constexpr (constexpr int k = normal_map(kMapsOf<Model>); k >= 0)
                if (arrays.tangent && texture_of(arrays, model.normal_texture)) {
                    const float side = side_of_normals(arrays, run_plane.corner,
                        glm::vec3(with_plane(run, world, hits.rays).plane));
                    normal =
                        mapped_normal(normal, at_hit(run_tangent(arrays, run_plane.corner, side)),
                            side * arrays.tangent[run_plane.corner.x].w, maps.map[k].rgb,
                            model.normal_scale);
                }
            return inputs_of(model, maps);
        }
    }();
    surface.normal = visible_normal(normal, surface.geometric, surface.to_eye);
    ShadeEnvironment environment;
    if constexpr (kReflectsEnvironment<Model>) environment = shade_environment(scene.environment);
    real3 color = emitted(inputs, environment.any() ? vec3(0) : scene.ambient);
    if constexpr (kReflectsEnvironment<Model>)
        if (environment.any())
            color = color + surrounded(inputs, around_light({&environment}, surface.normal,
                                                   surface.to_eye, roughness(inputs)));
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const Light& light = world.lights[l];
        real share = lit.lit ? lit.of_light(l)[at] : 1.0f;
        real3 to_light(0, 0, 0);
        if (light.kind == Light::Kind::point) {
            const real3 d = from_glm(glm::vec3(light.position)) - surface.position;
            to_light = unit(d);
            const float inv_range2 = shade_light(light).inv_range2;
            if (light.inverse_square) share = share * inverse_square(dot(d, d), inv_range2);
        } else if (light.kind == Light::Kind::directional) {
            to_light = from_glm(glm::vec3(-glm::normalize(light.direction)));
        } else {
            const glm::vec3 d = firsthit::to_light(light_space(light, glm::dvec3(hits.rays.eye)),
                {surface.position.x, surface.position.y, surface.position.z});
            const SpotCone cone = spot_cone(light);
            if (light.inverse_square)
                share = share * (squared_cone_share(versine(from_glm(cone.axis), from_glm(d)),
                                     cone.outer, cone.inv_width) *
                                    inverse_square(dot(from_glm(d), from_glm(d)),
                                        shade_light(light).inv_range2));
            else
                share = share * spot_share(cone, d);
            to_light = unit(real3(0, 0, 0) - from_glm(d));
        }
        if (!(share > 0)) continue;
        if (lit.lit && arrays.normal) share = share * terminator_share(surface, to_light);
        if constexpr (kReflects<Model>)
            color = color + reflected(inputs, surface, to_light, from_glm(light.color)) * share;
    }
    write(targets.position, surface.position);
    write(targets.geometric_normal, surface.geometric);
    write(targets.normal, surface.normal);
    write(targets.albedo, albedo(inputs));
    write(targets.color, color);
    if (targets.uv[0]) {
        targets.uv[0][at] = uv.x;
        targets.uv[1][at] = uv.y;
    }
    real3 own_light(0, 0, 0);
    real2 shares(0, 0);
    if constexpr (kReflectsEnvironment<Model>) {
        own_light = emission(inputs);
        shares = real2(metallic(inputs), roughness(inputs));
    }
    write(targets.emission, own_light);
    if (targets.metallic_roughness[0]) {
        targets.metallic_roughness[0][at] = shares.x;
        targets.metallic_roughness[1][at] = shares.y;
    }
}
} // namespace scalar

/// What a sample without a hit shows.
inline glm::vec3 plain_background(const HitTile& hits, const Scene& scene, int at)
{
    if (!shows_environment(scene)) return scene.background;
    const int block = at / kBlockSamples, in_block = at % kBlockSamples;
    const int blocks_x = hits.size / kBlock;
    const ShadeEnvironment environment = shade_environment(scene.environment);
    const scalar::real3 light = scalar::environment_from(
        {&environment}, scalar::ray_direction(hits.rays,
                            static_cast<float>(block % blocks_x * kBlock + block_x(in_block)),
                            static_cast<float>(block / blocks_x * kBlock + block_y(in_block))));
    return {light.x, light.y, light.z};
}

inline void plain_shade(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets)
{
    const int samples = hits.size * hits.size;
    for (int at = 0; at < samples; ++at)
        for (int axis = 0; axis < 3; ++axis) {
            for (auto* list : {&targets.normal, &targets.geometric_normal, &targets.position,
                     &targets.albedo, &targets.emission})
                if ((*list)[axis]) (*list)[axis][at] = 0;
            if (targets.color[axis])
                targets.color[axis][at] = plain_background(hits, *world.scene, at)[axis];
            if (axis < 2 && targets.uv[axis]) targets.uv[axis][at] = 0;
            if (axis < 2 && targets.metallic_roughness[axis])
                targets.metallic_roughness[axis][at] = 0;
        }
    for (const HitRun& run : hits.runs)
        for (int sample = 0; sample < kBlockSamples; ++sample)
            if (run.samples >> sample & 1) {
                const Scene& scene = *world.scene;
                const Material& material =
                    scene.materials[scene.instances[scene.owner[run.item]].material];
                std::visit(
                    [&](const auto& model) {
                        scalar::shade_sample(
                            hits, world, lit, targets, run, sample, material, model);
                    },
                    material.model);
            }
}

} // namespace firsthit
