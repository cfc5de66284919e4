// moving_scenes.cpp - meshes of which all vertices move, or a share of them.
#include "bench/baseline/moving_scenes.h"
#include "bench/measure/one_light.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace firsthit::cli::bench {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kPeriod = 5;  // seconds
constexpr float kTwist = 0.8f; // radians from bottom to top, at most

struct Mesh {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal; // of a cloth (-dy/dx, 1, -dy/dz), not unit
};

glm::vec3 turned(const glm::vec3& v, float sine, float cosine)
{
    return {cosine * v.x + sine * v.z, v.y, -sine * v.x + cosine * v.z};
}

/// Height of the still cloth and its slopes.
struct Ground {
    float y, dx, dz;
};

Ground ground(float x, float z)
{
    constexpr float kHeight = 0.08f, kA = 6.0f, kB = 5.0f;
    return {kHeight * std::sin(kA * x) * std::cos(kB * z),
        kHeight * kA * std::cos(kA * x) * std::cos(kB * z),
        -kHeight * kB * std::sin(kA * x) * std::sin(kB * z)};
}

/// Rows [first, last] of a cloth of `side` by `side` quads over [-1, 1] x [-1, 1].
void add_rows(std::uint32_t side, std::uint32_t first, std::uint32_t last, Mesh& mesh,
    std::vector<glm::uvec3>& index)
{
    const auto place = [&](std::uint32_t k) { return 2 * float(k) / float(side) - 1; };
    const auto begin = std::uint32_t(mesh.position.size());
    for (std::uint32_t row = first; row <= last; ++row)
        for (std::uint32_t column = 0; column <= side; ++column) {
            const Ground at = ground(place(column), place(row));
            mesh.position.emplace_back(place(column), at.y, place(row));
            mesh.normal.emplace_back(-at.dx, 1, -at.dz);
        }
    for (std::uint32_t row = 0; row < last - first; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t a = begin + row * (side + 1) + column, b = a + side + 1;
            index.emplace_back(a, b, a + 1);
            index.emplace_back(a + 1, b, b + 1);
        }
}

} // namespace

Scene twisting(Scene mesh)
{
    const auto still = std::make_shared<Mesh>(Mesh{mesh.position, mesh.normal});
    glm::vec3 low(0), high(0);
    if (!still->position.empty()) low = high = still->position.front();
    for (const glm::vec3& p : still->position) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 middle = 0.5f * (low + high);
    const float inv_height = 1 / std::max(high.y - low.y, 1e-30f);
    for (Instance& instance : mesh.instances) {
        instance.deform = [=, first_vertex = std::size_t(instance.first_vertex)](double time_s,
                              std::size_t first, std::size_t last, glm::vec3* position,
                              glm::vec3* normal) {
            const float twist = kTwist * float(std::sin(kTurn * time_s / kPeriod));
            for (std::size_t v = first; v < last; ++v) {
                const glm::vec3 from_middle = still->position[first_vertex + v] - middle;
                const float angle = twist * from_middle.y * inv_height;
                const float sine = std::sin(angle), cosine = std::cos(angle);
                position[v - first] = middle + turned(from_middle, sine, cosine);
                normal[v - first] = turned(still->normal[first_vertex + v], sine, cosine);
            }
        };
    }
    return mesh;
}

Scene with_moving_lights(Scene scene)
{
    leave_one_light(scene);
    for (Light& light : scene.lights) {
        if (light.kind == Light::Kind::directional || light.node >= 0) continue;
        Channel way;
        way.node = std::uint32_t(scene.nodes.size());
        for (const double time_s : {0.0, 1000.0}) {
            const glm::dvec3 position = light.position * (1 + 1e-4 * time_s);
            way.time_s.push_back(time_s);
            way.value.insert(way.value.end(), {position.x, position.y, position.z});
        }
        scene.nodes.push_back({.name = "a light that moves", .transform = NodeTransform{}});
        light.node = std::int32_t(way.node);
        light.position = glm::dvec3(0);
        if (scene.clips.empty()) scene.clips.emplace_back();
        scene.clips.front().channels.push_back(std::move(way));
    }
    return scene;
}

Scene partly_moving_cloth(std::uint64_t triangles, double share)
{
    const auto side = std::uint32_t(std::max(2.0, std::sqrt(double(triangles) / 2)));
    const auto moving = std::uint32_t(std::lround(share * side)); // rows of quads
    const auto cloth = std::make_shared<Mesh>();
    std::vector<glm::uvec3> index;
    // The row between the two is in both.
    if (moving < side) add_rows(side, 0, side - moving, *cloth, index);
    const std::size_t still_vertices = cloth->position.size(), still_triangles = index.size();
    if (moving > 0) add_rows(side, side - moving, side, *cloth, index);

    std::vector<glm::vec3> unit = cloth->normal;
    for (glm::vec3& n : unit) n = glm::normalize(n);
    Scene scene = scene_from_arrays(cloth->position, std::move(index), std::move(unit));
    scene.name = "cloth";
    const Instance whole = scene.instances.front();
    scene.instances.clear();
    if (still_triangles > 0) {
        Instance instance = whole;
        instance.name = "still";
        instance.vertex_count = std::uint32_t(still_vertices);
        instance.triangle_count = std::uint32_t(still_triangles);
        scene.instances.push_back(instance);
    }
    if (moving > 0) {
        Instance instance = whole;
        instance.name = "moving";
        instance.first_vertex = std::uint32_t(still_vertices);
        instance.vertex_count -= instance.first_vertex;
        instance.first_triangle = std::uint32_t(still_triangles);
        instance.triangle_count -= instance.first_triangle;
        instance.deform = [cloth, still_vertices](double time_s, std::size_t first,
                              std::size_t last, glm::vec3* position, glm::vec3* normal) {
            const float height = 1 + 0.2f * float(std::sin(kTurn * time_s / kPeriod));
            for (std::size_t v = first; v < last; ++v) {
                const glm::vec3 p = cloth->position[still_vertices + v],
                                n = cloth->normal[still_vertices + v];
                position[v - first] = {p.x, height * p.y, p.z};
                normal[v - first] = glm::normalize(glm::vec3(height * n.x, n.y, height * n.z));
            }
        };
        scene.instances.push_back(instance);
    }
    for (std::size_t t = still_triangles; t < scene.owner.size(); ++t)
        scene.owner[t] = std::uint32_t(scene.instances.size() - 1);
    return scene;
}

} // namespace firsthit::cli::bench
