// plain_shade.h - shading one sample after the other, from the same text: what kernels must equal.
#pragma once

#include "base/srgb.h"
#include "exact/shadow_ray.h"
#include "hits/hit_position.h"
#include "hits/known_run.h"
#include "hits/spot_cone.h"
#include "shade/phong_exponent.h"
#include "shade/run_setup.h"
#include "shade/shade_tile.h"

namespace firsthit {
namespace scalar {

#include "glsl/power.glsl"
#include "glsl/phong.glsl"
#include "glsl/texture.glsl"

inline real2 from_glm(const glm::vec2& v)
{
    return {v.x, v.y};
}

inline real3 texel_color(std::uint32_t rgba)
{
    const float* linear = linear_from_srgb().data();
    return {linear[rgba & 255], linear[rgba >> 8 & 255], linear[rgba >> 16 & 255]};
}

inline real3 sample_level(const Texture::Level& level, real u, real v)
{
    const Texels texels =
        bilinear_texels(u, v, static_cast<float>(level.width), static_cast<float>(level.height));
    const auto color = [&](integer i) { return texel_color(level.texel[std::size_t(i)]); };
    return blend3(blend3(color(texels.top_left), color(texels.top_right), texels.right),
        blend3(color(texels.bottom_left), color(texels.bottom_right), texels.right), texels.bottom);
}

inline real3 sample_texture(const Texture& texture, real u, real v, real length2)
{
    const real level = mip_level(length2, static_cast<float>(texture.levels.size() - 1));
    const real finer = floor(level);
    const std::size_t i = static_cast<std::size_t>(finer);
    const real3 fine = sample_level(texture.levels[i], u, v);
    // Black counts for nothing where amount is 0.
    const real3 coarse = level > finer ? sample_level(texture.levels[i + 1], u, v) : real3(0, 0, 0);
    return blend3(fine, coarse, level - finer);
}

inline void shade_sample(const HitTile& hits, const World& world, const LitTile& lit,
    const ShadeTargets& targets, const HitRun& run, int sample)
{
    const Scene& scene = *world.scene;
    const ShadeArrays arrays = shade_arrays(world);
    const RunPlane run_plane = firsthit::run_plane(arrays, run.item, hits.frame);
    const Interpolated<glm::vec3> run_normals = run_normal(
        arrays, run_plane.corner, glm::vec3(with_plane(run, world, hits.frame.eye).plane));
    const Interpolated<glm::vec2> run_uvs = run_uv(arrays, run_plane.corner);
    const Material& material = scene.materials[scene.parts[scene.owner[run.item]].material];
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
    const real3 direction = ray_direction(hits.frame, static_cast<float>(x), static_cast<float>(y));
    const real3 position = hit_position(from_glm(hits.frame.eye), direction, t);
    const real3 geometric = from_glm(geometric_normal(run_plane));
    const real3 to_eye = unit(real3(0, 0, 0) - direction);
    const real3 normal = visible_normal(
        from_glm(run_normals.at0) + (from_glm(run_normals.to1) * u + from_glm(run_normals.to2) * v),
        geometric, to_eye);
    const real2 less_corner = from_glm(run_uvs.to1) * u + from_glm(run_uvs.to2) * v;
    const real2 uv = from_glm(run_uvs.at0) + less_corner;

    real3 color_of_texture(1, 1, 1);
    if (const Texture* texture = texture_of(scene, material)) {
        const real2 size(static_cast<float>(texture->levels[0].width),
            static_cast<float>(texture->levels[0].height));
        const RunGradients gradients = run_gradients(run_plane, run_uvs, hits.frame);
        color_of_texture = sample_texture(*texture, uv.x, uv.y,
            footprint2(less_corner.x, less_corner.y, t, from_glm(gradients.u),
                from_glm(gradients.v), from_glm(gradients.one), size));
    }
    const real3 diffuse = from_glm(material.diffuse) * color_of_texture;
    real3 color = from_glm(material.ambient * scene.ambient) * color_of_texture;
    const PhongExponent exponent = phong_exponent(material.shininess);
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const Light& light = world.lights[l];
        real share = lit.lit ? lit.of_light(l)[at] : 1.0f;
        real3 to_light(0, 0, 0);
        if (light.kind == Light::Kind::point) {
            to_light = unit(from_glm(glm::vec3(light.position)) - position);
        } else if (light.kind == Light::Kind::directional) {
            to_light = from_glm(glm::vec3(-glm::normalize(light.direction)));
        } else {
            const glm::vec3 d = firsthit::to_light(light_space(light, glm::dvec3(hits.frame.eye)),
                {position.x, position.y, position.z});
            share = share * spot_share(spot_cone(light), d);
            to_light = unit(real3(0, 0, 0) - from_glm(d));
        }
        if (!(share > 0)) continue;
        const real cosine = lit_cosine(normal, to_light);
        const real glint =
            highlight(normal, to_eye, to_light, cosine, exponent.whole, exponent.value);
        color = color + reflected(from_glm(light.color), diffuse, cosine,
                            from_glm(material.specular), glint) *
                            share;
    }
    write(targets.position, position);
    write(targets.geometric_normal, geometric);
    write(targets.normal, normal);
    write(targets.albedo, diffuse);
    write(targets.color, color);
    if (targets.uv[0]) {
        targets.uv[0][at] = uv.x;
        targets.uv[1][at] = uv.y;
    }
}
} // namespace scalar

inline void plain_shade(
    const HitTile& hits, const World& world, const LitTile& lit, const ShadeTargets& targets)
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
            if (run.samples >> sample & 1)
                scalar::shade_sample(hits, world, lit, targets, run, sample);
}

} // namespace firsthit
