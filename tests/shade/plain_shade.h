// plain_shade.h - shading one sample after the other, from the same text: what kernels must equal.
#pragma once

#include "exact/shadow_ray.h"
#include "hits/hit_position.h"
#include "hits/known_run.h"
#include "hits/spot_cone.h"
#include "material/models.h"
#include "shade/run_setup.h"
#include "shade/shade_tile.h"

#include <array>
#include <variant>

namespace firsthit {
namespace scalar {

#include "glsl/power.glsl"
#include "glsl/texture.glsl"

using glm::vec3;

FIRSTHIT_PURE real3 all_lanes(const vec3& v)
{
    return {v.x, v.y, v.z};
}

#include "material/texts.inl"

inline real2 from_glm(const glm::vec2& v)
{
    return {v.x, v.y};
}

/// Adds the weighted texels of a level, 0 to -32768.
inline void add_level(
    const Texture& texture, int level, real u, real v, integer weight, std::array<integer, 3>& sum)
{
    const int width = texture.width(level), height = texture.height(level);
    const Texels at = bilinear_texels(
        repeat(u), 1.0f - repeat(v), static_cast<float>(width), static_cast<float>(height));
    const TexelWeights weights = texel_weights(at, weight);
    const auto row = texture.texels().subspan(std::size_t(texture.first()[std::size_t(level)]));
    const auto add = [&](integer index, integer share) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += share * row[std::size_t(index)][c];
    };
    add(at.top, weights.top_left);
    add(at.top + 1, weights.top_right);
    add(at.bottom, weights.bottom_left);
    add(at.bottom + 1, weights.bottom_right);
}

inline real3 sample_texture(const Texture& texture, real u, real v, real length2)
{
    const real level = mip_level(length2, static_cast<float>(texture.levels() - 1));
    const real finer = floor(level);
    const integer coarse = whole_to_integer((level - finer) * 32767.0f);
    std::array<integer, 3> sum{};
    add_level(texture, static_cast<int>(finer), u, v, whole_weight() - coarse, sum);
    if (coarse > 0) add_level(texture, static_cast<int>(finer) + 1, u, v, coarse, sum);
    return {texel_light(sum[0]), texel_light(sum[1]), texel_light(sum[2])};
}

template <class Model>
inline void shade_sample(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets, const HitRun& run, int sample, const Material& material,
    const Model& model)
{
    const Scene& scene = *world.scene;
    const ShadeArrays arrays = shade_arrays(world);
    const RunPlane run_plane = firsthit::run_plane(arrays, run.item, hits.rays);
    const Interpolated<glm::vec3> run_normals = run_normal(
        arrays, run_plane.corner, glm::vec3(with_plane(run, world, hits.rays.eye).plane));
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
    surface.normal = visible_normal(
        from_glm(run_normals.at0) + (from_glm(run_normals.to1) * u + from_glm(run_normals.to2) * v),
        surface.geometric, surface.to_eye);
    const real2 less_corner = from_glm(run_uvs.to1) * u + from_glm(run_uvs.to2) * v;
    const real2 uv = surface.uv = from_glm(run_uvs.at0) + less_corner;

    real3 color_of_texture(1, 1, 1);
    if (const Texture* texture = texture_of(scene, material)) {
        const real2 size(
            static_cast<float>(texture->width()), static_cast<float>(texture->height()));
        const RunGradients gradients = run_gradients(run_plane, run_uvs, hits.rays);
        color_of_texture = sample_texture(*texture, uv.x, uv.y,
            footprint2(less_corner.x, less_corner.y, t, from_glm(gradients.u),
                from_glm(gradients.v), from_glm(gradients.one), size));
    }
    const auto inputs = inputs_of(model, color_of_texture);
    real3 color = emitted(inputs, scene.ambient);
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const Light& light = world.lights[l];
        real share = lit.lit ? lit.of_light(l)[at] : 1.0f;
        real3 to_light(0, 0, 0);
        if (light.kind == Light::Kind::point) {
            to_light = unit(from_glm(glm::vec3(light.position)) - surface.position);
        } else if (light.kind == Light::Kind::directional) {
            to_light = from_glm(glm::vec3(-glm::normalize(light.direction)));
        } else {
            const glm::vec3 d = firsthit::to_light(light_space(light, glm::dvec3(hits.rays.eye)),
                {surface.position.x, surface.position.y, surface.position.z});
            share = share * spot_share(spot_cone(light), d);
            to_light = unit(real3(0, 0, 0) - from_glm(d));
        }
        if (!(share > 0)) continue;
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
}
} // namespace scalar

inline void plain_shade(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets)
{
    const int samples = hits.size * hits.size;
    for (int at = 0; at < samples; ++at)
        for (int axis = 0; axis < 3; ++axis) {
            for (auto* list :
                {&targets.normal, &targets.geometric_normal, &targets.position, &targets.albedo})
                if ((*list)[axis]) (*list)[axis][at] = 0;
            if (targets.color[axis]) targets.color[axis][at] = world.scene->background[axis];
            if (axis < 2 && targets.uv[axis]) targets.uv[axis][at] = 0;
        }
    for (const HitRun& run : hits.runs)
        for (int sample = 0; sample < kBlockSamples; ++sample)
            if (run.samples >> sample & 1) {
                const Scene& scene = *world.scene;
                const Material& material =
                    scene.materials[scene.parts[scene.owner[run.item]].material];
                std::visit(
                    [&](const auto& model) {
                        scalar::shade_sample(
                            hits, world, lit, targets, run, sample, material, model);
                    },
                    material.model);
            }
}

} // namespace firsthit
