// ground.cpp - a floor under what a scene shows.
#include <firsthit/ground.h>

#include <firsthit/error.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Gives an array that has values the same one for each vertex of the ground.
template <class T>
void extend(std::vector<T>& values, std::size_t vertices, const T& value)
{
    if (!values.empty()) values.resize(vertices, value);
}

bool is_usable(const Ground& ground)
{
    const glm::vec3& color = ground.color;
    return std::isfinite(glm::length(ground.middle)) && std::isfinite(glm::length(ground.up)) &&
           glm::length(ground.up) > 0 && std::isfinite(ground.half_side) && ground.half_side > 0 &&
           std::isfinite(glm::length(color)) && std::min({color.x, color.y, color.z}) >= 0;
}

} // namespace

std::uint32_t add_ground(Scene& scene, const Ground& ground)
{
    if (!is_usable(ground))
        throw ArgumentError(
            "a ground needs a finite middle, an upward direction, a side above 0 and a "
            "colour that is not negative");
    const glm::dvec3 up = glm::normalize(ground.up);
    const glm::dvec3 other = std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, up)) * ground.half_side;
    const glm::dvec3 front = glm::cross(up, right);

    const auto material = std::uint32_t(scene.materials.size());
    Material& paint = scene.materials.emplace_back();
    paint.name = "ground";
    if (scene.environment.map)
        paint.model = MetallicRoughness{
            .base_color = ground.color, .metallic = 0, .f0 = glm::vec3(0), .specular = 0};
    else
        paint.model = Phong{.ambient = ground.color, .diffuse = ground.color};
    scene.nodes.push_back({.name = "ground"});

    const std::size_t before = scene.vertices;
    Instance& instance = scene.instances.emplace_back();
    instance.name = "ground";
    instance.node = std::uint32_t(scene.nodes.size() - 1);
    instance.material = material;
    instance.first_vertex = std::uint32_t(before);
    instance.vertex_count = 4;
    instance.first_triangle = std::uint32_t(scene.index.size());
    instance.triangle_count = 2;

    scene.position.resize(before); // which may be empty where all instances write their own
    scene.normal.resize(before);
    for (const glm::dvec2& corner :
        {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
        scene.position.emplace_back(ground.middle + corner.x * right + corner.y * front);
        scene.normal.emplace_back(up);
    }
    scene.vertices = before + 4;
    extend(scene.uv, scene.vertices, glm::vec2(0));
    extend(scene.uv1, scene.vertices, glm::vec2(0));
    extend(scene.color, scene.vertices, glm::vec4(1));
    extend(scene.tangent, scene.vertices, glm::vec4(glm::normalize(right), 1));
    const auto first = std::uint32_t(before);
    scene.index.emplace_back(first, first + 1, first + 2);
    scene.index.emplace_back(first, first + 2, first + 3);
    scene.owner.resize(scene.index.size(), std::uint32_t(scene.instances.size() - 1));
    return material;
}

} // namespace firsthit
