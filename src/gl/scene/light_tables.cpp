// light_tables.cpp - tables of lights and shadow maps for shaders.
#include "gl/scene/light_tables.h"

#include "shade/shade_light.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace firsthit::gl {
namespace {

static_assert(kFaces == firsthit::kFaces);

constexpr float kRounding = 0x1p-20f; // the same as in shadow/map/sample_shadow_map.cpp

/// Factor of the slope bias, the same as in shadow/map/sample_shadow_map.cpp: neighbouring
/// triangles are not in the receiver's plane.
constexpr double kNeighbours = 1.5;

/// The face that all hits of a light lie on, or -1 if there are several.
int only_face(const ShadowLight& light)
{
    int faces = 0, only = -1;
    for (int face = 0; face < kFaces; ++face)
        if (light.map[std::size_t(face)].width() > 0) ++faces, only = face;
    return faces == 1 ? only : -1;
}

} // namespace

void fill_lights(const World& world, const Rays& rays, std::span<const ShadowLight> maps,
    std::vector<LightData>& lights)
{
    lights.clear();
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const ShadeLight shade = shade_light(world.lights[l]);
        const LightFrame axes = light_frame(world.lights[l]);
        const glm::dmat3 rows = glm::transpose(axes.axes);
        lights.push_back({.to_frame = transformed(rays, axes.axes, axes.origin, glm::dvec3(0)),
            .color = shade.color,
            .kind = std::int32_t(shade.kind),
            .position = shade.position,
            .tan2_cone = float(axes.tan2_cone),
            .to_light = shade.to_light,
            .only_face = l < maps.size() ? only_face(maps[l]) : -1,
            .axis = shade.cone.axis,
            .outer = shade.cone.outer,
            .frame_x = glm::vec3(rows[0]),
            .inv_width = shade.cone.inv_width,
            .frame_y = glm::vec3(rows[1]),
            .cube = axes.cube,
            .frame_z = glm::vec3(rows[2]),
            .inv_range2 = shade.inv_range2});
    }
}

void fill_maps(std::span<const ShadowLight> lights, const Rays& rays,
    std::span<const std::uint32_t> first, int filter, std::vector<MapData>& maps)
{
    maps.clear();
    for (std::size_t k = 0; k < lights.size() * kFaces; ++k) {
        const ShadowMap& map = lights[k / kFaces].map[k % kFaces];
        MapData data;
        if (map.width() > 0) {
            const glm::dvec3 eye = glm::abs(glm::dvec3(rays.eye) - map.origin);
            data.to_map = transformed(rays, map.matrix, map.origin, map.offset);
            data.first = first[k];
            data.width = map.width();
            data.height = map.height();
            data.reach = float(kNeighbours * 0.5 * filter * map.source.fit.texel);
            data.rounding = kRounding * float(eye.x + eye.y + eye.z);
        }
        maps.push_back(data);
    }
}

} // namespace firsthit::gl
