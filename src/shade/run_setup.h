// run_setup.h - what all samples of one triangle share, fetched and worked out once a run.
#pragma once

#include "base/pure.h"
#include "hits/hit_tile.h"

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

/// The triangle behind a run, as shading sees it.
struct RunSetup {
    std::uint32_t material = 0;
    glm::vec3 geometric{0};         // unit, towards the eye; 0 where the triangle has no area
    Interpolated<glm::vec3> normal; // of the side that the eye is on, not unit
    Interpolated<glm::vec2> uv;
    // Gradients for footprint2 (src/glsl/texture.glsl).
    glm::vec2 grad_u{0};
    glm::vec2 grad_v{0};
    glm::vec2 grad_1{0};
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
    ShadeArrays arrays{.scene = world.scene, .position = world.position.data()};
    if (world.normal.size() >= vertices) arrays.normal = world.normal.data();
    if (world.scene->uv.size() >= vertices) arrays.uv = world.scene->uv.data();
    return arrays;
}

/// The texture of a material, or null.
inline const Texture* texture_of(const Scene& scene, const Material& material)
{
    if (material.texture < 0 || std::size_t(material.texture) >= scene.textures.size())
        return nullptr;
    const Texture& texture = scene.textures[std::size_t(material.texture)];
    return texture.levels.empty() ? nullptr : &texture;
}

/// In double, so that neither tiny nor huge triangles lose their normal to float's range.
FIRSTHIT_PURE RunSetup set_up_run(
    const ShadeArrays& arrays, std::uint32_t item, const TileFrame& frame)
{
    RunSetup run;
    run.material = arrays.scene->parts[arrays.scene->owner[item]].material;
    const glm::uvec3 corner = arrays.scene->index[item];

    // The plane, and the side of it that the eye is on: the same for all samples.
    const glm::dvec3 p0(arrays.position[corner.x]);
    const glm::dvec3 e1 = glm::dvec3(arrays.position[corner.y]) - p0;
    const glm::dvec3 e2 = glm::dvec3(arrays.position[corner.z]) - p0;
    const glm::dvec3 n = glm::cross(e1, e2);
    const glm::dvec3 p0_eye = p0 - glm::dvec3(frame.eye);
    const double n_p0 = glm::dot(n, p0_eye);
    const double side = n_p0 > 0 ? -1 : 1;
    const double length = std::sqrt(glm::dot(n, n));
    if (length > 0) run.geometric = glm::vec3(n * (side / length));

    // Normals go by the plane's side, not by the winding, which in real files opposes some of them.
    if (arrays.normal) {
        const glm::vec3 n0 = arrays.normal[corner.x];
        const glm::vec3 n1 = arrays.normal[corner.y];
        const glm::vec3 n2 = arrays.normal[corner.z];
        const float flip = glm::dot(n0 + n1 + n2, run.geometric) < 0 ? -1.0f : 1.0f;
        run.normal.at0 = n0 * flip;
        run.normal.to1 = (n1 - n0) * flip;
        run.normal.to2 = (n2 - n0) * flip;
    }
    if (arrays.uv) {
        run.uv.at0 = arrays.uv[corner.x];
        run.uv.to1 = arrays.uv[corner.y] - run.uv.at0;
        run.uv.to2 = arrays.uv[corner.z] - run.uv.at0;
    }

    // Only textured triangles have a footprint.
    if (arrays.uv && texture_of(*arrays.scene, arrays.scene->materials[run.material])) {
        const glm::dvec3 w1 = glm::cross(e2, p0_eye);
        const glm::dvec3 w2 = glm::cross(p0_eye, e1);
        const glm::dvec3 right(frame.world_from_eye[0]);
        const glm::dvec3 down(frame.world_from_eye[1]);
        const double step = double(frame.inv_f) / n_p0;
        const glm::dvec2 w1_xy(glm::dot(w1, right) * step, glm::dot(w1, down) * step);
        const glm::dvec2 w2_xy(glm::dot(w2, right) * step, glm::dot(w2, down) * step);
        run.grad_1 = glm::vec2(glm::dot(n, right) * step, glm::dot(n, down) * step);
        run.grad_u = glm::vec2(w1_xy * double(run.uv.to1.x) + w2_xy * double(run.uv.to2.x));
        run.grad_v = glm::vec2(w1_xy * double(run.uv.to1.y) + w2_xy * double(run.uv.to2.y));
    }
    return run;
}

} // namespace firsthit
