// builtin_torus.cpp - the paper's torus.
#include "samples/builtin.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr std::uint32_t kAround = 32; // quads around the axis
constexpr std::uint32_t kTube = 16;   // quads around the tube
constexpr double kRadius = 1.0;       // of the tube's middle line
constexpr double kTubeRadius = 0.42;

} // namespace

Scene make_torus()
{
    Scene scene;
    scene.name = "torus";
    scene.nodes.push_back({.name = "torus"});
    Material& material = scene.materials.emplace_back();
    material.name = "torus";
    material.model = Phong{.ambient = {0.06f, 0.03f, 0.02f},
        .diffuse = {0.80f, 0.30f, 0.12f},
        .specular = glm::vec3(0.5f),
        .shininess = 40.0f};

    // The axis is y; rings of the tube one after another, the last joined to the first.
    for (std::uint32_t i = 0; i < kAround; ++i) {
        const double a = 2 * std::numbers::pi * i / kAround;
        for (std::uint32_t j = 0; j < kTube; ++j) {
            const double b = 2 * std::numbers::pi * j / kTube;
            const glm::dvec3 normal(
                std::cos(b) * std::cos(a), std::sin(b), -std::cos(b) * std::sin(a));
            const glm::dvec3 middle(kRadius * std::cos(a), 0, -kRadius * std::sin(a));
            scene.position.emplace_back(middle + kTubeRadius * normal);
            scene.normal.emplace_back(normal);
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
            scene.index.emplace_back(a, b, c);
            scene.index.emplace_back(a, c, d);
        }
    scene.vertices = scene.position.size();
    scene.owner.assign(scene.index.size(), 0);
    Part& part = scene.parts.emplace_back();
    part.name = "torus";
    part.vertex_count = kAround * kTube;
    part.triangle_count = kAround * kTube * 2;

    Camera camera;
    camera.eye = {0, 2.35, 2.6};
    camera.direction = glm::dvec3(0, -0.08, 0.09) - camera.eye;
    camera.fov_y_rad = 0.84;
    scene.camera = camera;
    scene.lights.push_back({.position = {2.5, 5, 3}});
    scene.background = {0.02f, 0.03f, 0.05f};
    return scene;
}

} // namespace firsthit
