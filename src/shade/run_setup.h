// run_setup.h - what all samples of a run share, loaded and computed once for each run.
#pragma once

#include "base/pure.h"
#include "hits/known_run.h"
#include "material/models.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

namespace firsthit {

/// A vertex attribute as a linear function of the hit's barycentrics: value = at0 + u * to1 + v *
/// to2. Exact if all corners have the same value.
template <class Vec>
struct Interpolated {
    Vec at0{0};
    Vec to1{0}; // value at corner 1 minus at0
    Vec to2{0}; // value at corner 2 minus at0
};

/// The arrays of a World that shading reads. Their sizes are checked once for each tile.
struct ShadeArrays {
    const Scene* scene = nullptr;
    const glm::vec3* position = nullptr;
    const glm::vec3* normal = nullptr;  // null: the world has none
    const glm::vec2* uv = nullptr;      // null: the scene has none
    const glm::vec2* uv1 = nullptr;     // null: the scene has none
    const glm::vec4* color = nullptr;   // null: the scene has none, all are 1
    const glm::vec4* tangent = nullptr; // null: the world has none
};

inline ShadeArrays shade_arrays(const World& world)
{
    const std::size_t vertices = world.position.size();
    ShadeArrays arrays{.scene = world.scene.get(), .position = world.position.data()};
    if (world.normal.size() >= vertices) arrays.normal = world.normal.data();
    const Scene& scene = *world.scene;
    if (scene.uv.size() >= vertices) arrays.uv = scene.uv.data();
    if (scene.uv1.size() >= vertices) arrays.uv1 = scene.uv1.data();
    if (scene.color.size() >= vertices) arrays.color = scene.color.data();
    if (world.tangent.size() >= vertices) arrays.tangent = world.tangent.data();
    return arrays;
}

/// A texture of the scene; null if there is none of that number, or it has no texels (and is white).
inline const Texture* drawn_texture(const Scene& scene, std::int32_t number)
{
    if (number < 0 || std::size_t(number) >= scene.textures.size()) return nullptr;
    const Texture& texture = scene.textures[std::size_t(number)];
    return texture.levels() == 0 ? nullptr : &texture;
}

/// The texture of a material without maps; null if it has none, or one without texels.
inline const Texture* texture_of(const Scene& scene, const Material& material)
{
    return drawn_texture(scene, texture_number(material));
}

/// The texture of a map; null if it has none, or the scene lacks its texture coordinates.
inline const Texture* texture_of(const ShadeArrays& arrays, const TextureRef& map)
{
    if (!(map.uv_set == 0 ? arrays.uv : arrays.uv1)) return nullptr;
    return drawn_texture(*arrays.scene, map.texture);
}

/// The attributes that the maps of a material need.
struct MapNeeds {
    bool uv[2] = {}; // texture coordinates and their steps, for each set
    bool tangent = false;
};

inline MapNeeds map_needs(const ShadeArrays& arrays, const Material& material)
{
    MapNeeds needs;
    std::visit(
        [&](const auto& model) {
            constexpr std::span<const ModelMap> kMaps = kMapsOf<std::decay_t<decltype(model)>>;
            for (std::size_t k = 0; k < kMaps.size(); ++k) {
                const TextureRef& map = map_of(model, kMaps[k]);
                if (!texture_of(arrays, map)) continue;
                needs.uv[map.uv_set == 0 ? 0 : 1] = true;
                if (int(k) == normal_map(kMaps)) needs.tangent = arrays.tangent != nullptr;
            }
        },
        material.model);
    return needs;
}

/// The plane of a triangle relative to the eye. Where the rays are parallel, p0_eye is their direction, with
/// which run_gradients finds what it looks for in the same way. In double, because the products of very
/// small and very large coordinates are outside the range of float.
struct RunPlane {
    glm::uvec3 corner{0};
    glm::dvec3 p0_eye{0}; // corner 0 minus the eye; or the direction of parallel rays
    glm::dvec3 e1{0};     // corner 1 minus corner 0
    glm::dvec3 e2{0};     // corner 2 minus corner 0
    glm::dvec3 n{0};      // e1 x e2
    double n_p0 = 0;      // n . p0_eye
};

FIRSTHIT_PURE RunPlane run_plane(const ShadeArrays& arrays, std::uint32_t item, const Rays& rays)
{
    RunPlane plane;
    plane.corner = arrays.scene->index[item];
    const glm::dvec3 p0(arrays.position[plane.corner.x]);
    plane.p0_eye = rays.parallel ? glm::dvec3(rays.forward) : p0 - glm::dvec3(rays.eye);
    plane.e1 = glm::dvec3(arrays.position[plane.corner.y]) - p0;
    plane.e2 = glm::dvec3(arrays.position[plane.corner.z]) - p0;
    plane.n = glm::cross(plane.e1, plane.e2);
    plane.n_p0 = glm::dot(plane.n, plane.p0_eye);
    return plane;
}

/// The unit normal of the run's triangle, towards the eye; 0 if the triangle has no area.
FIRSTHIT_PURE glm::vec3 geometric_normal(
    const ShadeArrays& arrays, const HitRun& run, const Rays& rays)
{
    const RunPlane plane = run_plane(arrays, run.item, rays);
    const double length = std::sqrt(glm::dot(plane.n, plane.n));
    if (!(length > 0)) return glm::vec3(0);
    const double side = looks_away(run, plane.n, plane.n_p0, rays) ? -1 : 1;
    return glm::vec3(plane.n * (side / length));
}

/// 1, or -1 if the corners' normals point away from the eye's side of the triangle's plane. The side
/// is found from the plane, not from the order of corners, because in real files some normals
/// contradict that order.
FIRSTHIT_PURE float side_of_normals(
    const ShadeArrays& arrays, const glm::uvec3& corner, const glm::vec3& to_eye)
{
    const glm::vec3 sum =
        arrays.normal[corner.x] + arrays.normal[corner.y] + arrays.normal[corner.z];
    const float along = (sum.x * to_eye.x + sum.y * to_eye.y) + sum.z * to_eye.z;
    return along < 0 ? -1.0f : 1.0f;
}

/// The interpolated normal on the eye's side of the triangle's plane, not unit; 0 if the world has
/// no normals.
///
/// to_eye  the plane's normal towards the eye (HitRun::plane)
FIRSTHIT_PURE Interpolated<glm::vec3> run_normal(
    const ShadeArrays& arrays, const glm::uvec3& corner, const glm::vec3& to_eye)
{
    if (!arrays.normal) return {};
    const glm::vec3 n0 = arrays.normal[corner.x];
    const glm::vec3 n1 = arrays.normal[corner.y];
    const glm::vec3 n2 = arrays.normal[corner.z];
    const float flip = side_of_normals(arrays, corner, to_eye);
    return {n0 * flip, (n1 - n0) * flip, (n2 - n0) * flip};
}

/// Surface::flat_normal and Surface::bend, which all samples of a run share.
struct RunFacing {
    glm::vec3 normal{0};
    float bend = 0; // 0 where all corners are far off
};

/// to_eye  the plane's normal towards the eye (HitRun::plane), of a world with normals
FIRSTHIT_PURE RunFacing run_facing(
    const ShadeArrays& arrays, const glm::uvec3& corner, const glm::vec3& to_eye)
{
    constexpr float kMostBend = 0.45f; // light would fade too far from the border
    const float length2 = (to_eye.x * to_eye.x + to_eye.y * to_eye.y) + to_eye.z * to_eye.z;
    if (!(length2 > 0)) return {};
    const glm::vec3 n = to_eye * (1 / std::sqrt(length2));
    const float side = side_of_normals(arrays, corner, to_eye);
    float most = 0;
    for (int k = 0; k < 3; ++k) {
        const glm::vec3& m = arrays.normal[corner[k]];
        most = std::max(most, side * ((m.x * n.x + m.y * n.y) + m.z * n.z));
    }
    const float square = 1 - most * most;
    return {n, most > 0 && square > 0 ? std::min(std::sqrt(square), kMostBend) : 0.0f};
}

/// The interpolated tangent, flipped where run_normal flips the normal.
/// side  that of side_of_normals
FIRSTHIT_PURE Interpolated<glm::vec3> run_tangent(
    const ShadeArrays& arrays, const glm::uvec3& corner, float side)
{
    const glm::vec3 t0(arrays.tangent[corner.x]);
    const glm::vec3 t1(arrays.tangent[corner.y]);
    const glm::vec3 t2(arrays.tangent[corner.z]);
    return {t0 * side, (t1 - t0) * side, (t2 - t0) * side};
}

/// The interpolated colour of the vertices.
FIRSTHIT_PURE Interpolated<glm::vec3> run_color(const ShadeArrays& arrays, const glm::uvec3& corner)
{
    const glm::vec3 c0(arrays.color[corner.x]);
    return {c0, glm::vec3(arrays.color[corner.y]) - c0, glm::vec3(arrays.color[corner.z]) - c0};
}

/// The interpolated second texture coordinates.
FIRSTHIT_PURE Interpolated<glm::vec2> run_uv1(const ShadeArrays& arrays, const glm::uvec3& corner)
{
    const glm::vec2 uv0 = arrays.uv1[corner.x];
    return {uv0, arrays.uv1[corner.y] - uv0, arrays.uv1[corner.z] - uv0};
}

/// The interpolated texture coordinates; 0 if the scene has none.
FIRSTHIT_PURE Interpolated<glm::vec2> run_uv(const ShadeArrays& arrays, const glm::uvec3& corner)
{
    if (!arrays.uv) return {};
    const glm::vec2 uv0 = arrays.uv[corner.x];
    return {uv0, arrays.uv[corner.y] - uv0, arrays.uv[corner.z] - uv0};
}

/// The arguments grad_u, grad_v and grad_1 of footprint2 (src/glsl/texture.glsl). Its t is footprint_depth.
struct RunGradients {
    glm::vec2 u{0};
    glm::vec2 v{0};
    glm::vec2 one{0};
};

FIRSTHIT_PURE RunGradients run_gradients(
    const RunPlane& plane, const Interpolated<glm::vec2>& uv, const Rays& rays)
{
    const glm::dvec3 w1 = glm::cross(plane.e2, plane.p0_eye);
    const glm::dvec3 w2 = glm::cross(plane.p0_eye, plane.e1);
    const glm::dvec3 right(rays.right), down(rays.down);
    const double step_x = double(rays.step_x) / plane.n_p0;
    const double step_y = double(rays.step_y) / plane.n_p0;
    const glm::dvec2 w1_xy(glm::dot(w1, right) * step_x, glm::dot(w1, down) * step_y);
    const glm::dvec2 w2_xy(glm::dot(w2, right) * step_x, glm::dot(w2, down) * step_y);
    RunGradients gradients;
    // Parallel rays do not spread.
    if (!rays.parallel)
        gradients.one =
            glm::vec2(glm::dot(plane.n, right) * step_x, glm::dot(plane.n, down) * step_y);
    gradients.u = glm::vec2(w1_xy * double(uv.to1.x) + w2_xy * double(uv.to2.x));
    gradients.v = glm::vec2(w1_xy * double(uv.to1.y) + w2_xy * double(uv.to2.y));
    return gradients;
}

} // namespace firsthit
