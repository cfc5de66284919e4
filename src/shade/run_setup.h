// run_setup.h - what all samples of one triangle share, fetched and worked out once a run.
#pragma once

#include "base/pure.h"
#include "hits/known_run.h"
#include "material/models.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace firsthit {

/// Linear in the hit's weights: value = at0 + u * to1 + v * to2. Exact where all corners agree.
template <class Vec>
struct Interpolated {
    Vec at0{0};
    Vec to1{0}; // value at corner 1, less at0
    Vec to2{0};
};

/// What of a World shading reads, checked once a tile.
struct ShadeArrays {
    const Scene* scene = nullptr;
    const glm::vec3* position = nullptr;
    const glm::vec3* normal = nullptr; // null: none
    const glm::vec2* uv = nullptr;     // null: none
};

inline ShadeArrays shade_arrays(const World& world)
{
    const std::size_t vertices = world.position.size();
    ShadeArrays arrays{.scene = world.scene.get(), .position = world.position.data()};
    if (world.normal.size() >= vertices) arrays.normal = world.normal.data();
    if (world.scene->uv.size() >= vertices) arrays.uv = world.scene->uv.data();
    return arrays;
}

/// The texture of a material, or null.
inline const Texture* texture_of(const Scene& scene, const Material& material)
{
    const std::int32_t number = texture_number(material);
    if (number < 0 || std::size_t(number) >= scene.textures.size()) return nullptr;
    const Texture& texture = scene.textures[std::size_t(number)];
    return texture.levels() == 0 ? nullptr : &texture;
}

/// The triangle's plane as the eye sees it, the same for all samples. In double, so that neither tiny
/// nor huge triangles lose their normal to float's range.
struct RunPlane {
    glm::uvec3 corner{0};
    glm::dvec3 p0_eye{0}; // corner 0 from the eye
    glm::dvec3 e1{0};     // corner 1 from corner 0
    glm::dvec3 e2{0};
    glm::dvec3 n{0}; // e1 x e2
    double n_p0 = 0; // n . p0_eye
};

FIRSTHIT_PURE RunPlane run_plane(const ShadeArrays& arrays, std::uint32_t item, const Rays& rays)
{
    RunPlane plane;
    plane.corner = arrays.scene->index[item];
    const glm::dvec3 p0(arrays.position[plane.corner.x]);
    plane.p0_eye = p0 - glm::dvec3(rays.eye);
    plane.e1 = glm::dvec3(arrays.position[plane.corner.y]) - p0;
    plane.e2 = glm::dvec3(arrays.position[plane.corner.z]) - p0;
    plane.n = glm::cross(plane.e1, plane.e2);
    plane.n_p0 = glm::dot(plane.n, plane.p0_eye);
    return plane;
}

/// Unit, towards the eye; 0 where the triangle has no area.
FIRSTHIT_PURE glm::vec3 geometric_normal(
    const ShadeArrays& arrays, const HitRun& run, const Rays& rays)
{
    const RunPlane plane = run_plane(arrays, run.item, rays);
    const double length = std::sqrt(glm::dot(plane.n, plane.n));
    if (!(length > 0)) return glm::vec3(0);
    const double side = looks_away(run, plane.n, plane.n_p0, rays.eye) ? -1 : 1;
    return glm::vec3(plane.n * (side / length));
}

/// Of the side that the eye is on, not unit; 0 where the world has none. Normals go by the plane's
/// side, not by the winding, which in real files opposes some of them.
///
/// to_eye  the plane's normal towards the eye (HitRun::plane)
FIRSTHIT_PURE Interpolated<glm::vec3> run_normal(
    const ShadeArrays& arrays, const glm::uvec3& corner, const glm::vec3& to_eye)
{
    if (!arrays.normal) return {};
    const glm::vec3 n0 = arrays.normal[corner.x];
    const glm::vec3 n1 = arrays.normal[corner.y];
    const glm::vec3 n2 = arrays.normal[corner.z];
    const glm::vec3 sum = n0 + n1 + n2;
    const float along = (sum.x * to_eye.x + sum.y * to_eye.y) + sum.z * to_eye.z;
    const float flip = along < 0 ? -1.0f : 1.0f;
    return {n0 * flip, (n1 - n0) * flip, (n2 - n0) * flip};
}

/// Texture coordinates.
FIRSTHIT_PURE Interpolated<glm::vec2> run_uv(const ShadeArrays& arrays, const glm::uvec3& corner)
{
    if (!arrays.uv) return {};
    const glm::vec2 uv0 = arrays.uv[corner.x];
    return {uv0, arrays.uv[corner.y] - uv0, arrays.uv[corner.z] - uv0};
}

/// Gradients for footprint2 (src/glsl/texture.glsl).
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
    gradients.one = glm::vec2(glm::dot(plane.n, right) * step_x, glm::dot(plane.n, down) * step_y);
    gradients.u = glm::vec2(w1_xy * double(uv.to1.x) + w2_xy * double(uv.to2.x));
    gradients.v = glm::vec2(w1_xy * double(uv.to1.y) + w2_xy * double(uv.to2.y));
    return gradients;
}

} // namespace firsthit
