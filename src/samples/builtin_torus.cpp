// builtin_torus.cpp - the paper's torus.
#include "samples/builtin.h"

#include <firsthit/scene_builder.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

constexpr std::uint32_t kAround = 32; // quads around the axis
constexpr std::uint32_t kTube = 16;   // quads around the tube
constexpr double kRadius = 1.0;       // of the tube's middle line
constexpr double kTubeRadius = 0.42;

} // namespace

Scene make_torus()
{
    Material material;
    material.name = "torus";
    material.model = Phong{.ambient = {0.06f, 0.03f, 0.02f},
        .diffuse = {0.80f, 0.30f, 0.12f},
        .specular = glm::vec3(0.5f),
        .shininess = 40.0f};
    Mesh mesh;

    // The axis is y; rings of the tube one after another, the last joined to the first.
    for (std::uint32_t i = 0; i < kAround; ++i) {
        const double a = 2 * std::numbers::pi * i / kAround;
        for (std::uint32_t j = 0; j < kTube; ++j) {
            const double b = 2 * std::numbers::pi * j / kTube;
            const glm::dvec3 normal(
                std::cos(b) * std::cos(a), std::sin(b), -std::cos(b) * std::sin(a));
            const glm::dvec3 middle(kRadius * std::cos(a), 0, -kRadius * std::sin(a));
            mesh.position.emplace_back(middle + kTubeRadius * normal);
            mesh.normal.emplace_back(normal);
        }
    }
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t j = 0; j < kTube; ++j) {
            const std::uint32_t next_ring = (i + 1) % kAround * kTube;
            const std::uint32_t next = (j + 1) % kTube;
            const std::uint32_t a = i * kTube + j;
            const std::uint32_t b = next_ring + j;
            const std::uint32_t c = next_ring + next;
            const std::uint32_t d = i * kTube + next;
            mesh.index.emplace_back(a, b, c);
            mesh.index.emplace_back(a, c, d);
        }

    SceneBuilder builder("torus");
    builder.add_instance(builder.add_mesh(std::move(mesh)), builder.add_node({.name = "torus"}),
        builder.add_material(std::move(material)));
    Camera camera;
    camera.eye = {0, 2.35, 2.6};
    camera.direction = glm::dvec3(0, -0.08, 0.09) - camera.eye;
    camera.fov_y_rad = 0.84;
    builder.add_camera({.name = "camera", .camera = camera});
    builder.add_light({.position = {2.5, 5, 3}});
    builder.set_background({0.02f, 0.03f, 0.05f});
    return builder.build();
}

} // namespace firsthit
