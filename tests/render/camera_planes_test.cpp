// camera_planes_test.cpp - normals and positions in the camera's frame.
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit::test {
namespace {

TEST(CameraPlanes, AreTheWorldsTurnedByTheCamera)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(std::make_shared<const Scene>(scene), 0, world);
    View view;
    view.camera.eye = {2, 1.5, 3};
    view.camera.direction = {-2, -1.4, -3};
    view.camera.up = {0.2, 1, 0};
    view.width = 80;
    view.height = 60;
    view.camera.focal = {70, 90};
    view.camera.principal_point = {33.3, 37.7};
    view.camera.skew = 5;
    view.region = {10, 5, 60, 50};
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::normal_camera, Aov::position_camera};
    Renderer renderer(2);
    Film film, own;
    renderer.render(world, view, settings, film);
    EXPECT_TRUE(film[Aov::normal].empty());
    EXPECT_TRUE(film[Aov::depth].empty());
    settings.aovs = {Aov::normal, Aov::position, Aov::depth, Aov::item};
    renderer.render(world, view, settings, own);

    const glm::dvec3 forward = glm::normalize(view.camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.camera.up));
    const glm::dvec3 down = glm::cross(forward, right);
    int hits = 0;
    for (std::size_t k = 0; k < own.item.size(); ++k) {
        const float* const n = &film[Aov::normal_camera].value[3 * k];
        const float* const p = &film[Aov::position_camera].value[3 * k];
        if (own.item[k] == kNoItem) {
            for (int c = 0; c < 3; ++c) ASSERT_EQ(std::abs(n[c]) + std::abs(p[c]), 0);
            continue;
        }
        ++hits;
        const auto vector = [&](Aov aov) {
            const float* const v = &own[aov].value[3 * k];
            return glm::dvec3(v[0], v[1], v[2]);
        };
        const glm::dvec3 from_eye = vector(Aov::position) - view.camera.eye;
        const glm::dvec3 normal = vector(Aov::normal);
        ASSERT_NEAR(p[0], glm::dot(from_eye, right), 2e-5);
        ASSERT_NEAR(p[1], glm::dot(from_eye, down), 2e-5);
        ASSERT_EQ(p[2], own[Aov::depth].value[k]);
        ASSERT_NEAR(n[0], glm::dot(normal, right), 1e-6);
        ASSERT_NEAR(n[1], glm::dot(normal, down), 1e-6);
        ASSERT_NEAR(n[2], glm::dot(normal, forward), 1e-6);
        // The pixel that the calibration says.
        const double x = 10 + double(k % 60) + 0.5, y = 5 + double(k / 60) + 0.5;
        ASSERT_NEAR(70.0 * p[0] / p[2] + 5.0 * p[1] / p[2] + 33.3, x, 1e-4);
        ASSERT_NEAR(90.0 * p[1] / p[2] + 37.7, y, 1e-4);
    }
    EXPECT_GT(hits, 100);
}

} // namespace
} // namespace firsthit::test
