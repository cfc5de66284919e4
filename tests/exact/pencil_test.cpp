// pencil_test.cpp - a camera's rays against the formulas of a textbook, and exact.
#include "exact/pencil.h"
#include "exact/rays.h"
#include "message_of.h"

#include <firsthit/error.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace firsthit::test {
namespace {

/// A camera that looks somewhere, and its axes.
struct Calibrated {
    View view{.camera = {.eye = {3, -2, 5}, .direction = {0.3, -1, 0.2}, .up = {0.1, 0.2, 2}},
        .width = 640,
        .height = 482,
        .region = {}};
    glm::dvec3 right, down, forward;

    Calibrated()
    {
        forward = glm::normalize(view.camera.direction);
        right = glm::normalize(glm::cross(forward, view.camera.up));
        down = glm::cross(forward, right);
    }

    /// The ray through a place of the picture, in pixels from its top left corner.
    glm::dvec3 ray(double px, double py) const
    {
        const glm::dvec2 f = *view.camera.focal, c = *view.camera.principal_point;
        const double v = (py - c.y) / f.y;
        const double u = (px - c.x - view.camera.skew * v) / f.x;
        return u * right + v * down + forward;
    }
};

Calibrated random_camera(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    Calibrated made;
    made.view.camera.focal = glm::dvec2(200 + 2000 * unit(random), 200 + 2000 * unit(random));
    made.view.camera.principal_point =
        glm::dvec2(1500 * unit(random) - 500, 1500 * unit(random) - 500);
    made.view.camera.skew = 200 * unit(random) - 100;
    return made;
}

TEST(Pencil, HasTheRaysOfTheTextbook)
{
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        const Calibrated made = random_camera(random);
        const int samples = 1 + round % 4;
        const Region region{round, 2 * round, 100, 80};
        const Pencil pencil = pencil_of(made.view, region, samples);
        ASSERT_EQ(pencil.width, 100 * samples);
        ASSERT_EQ(pencil.height, 80 * samples);
        const Rays rays = world_rays(pencil, pencil.tile(0, 0));
        for (int k = 0; k < 20; ++k) {
            const int x = int(random() % unsigned(pencil.width)),
                      y = int(random() % unsigned(pencil.height));
            const glm::vec3 sample = pencil.tile(0, 0).direction(x, y);
            // Exact, whatever the principal point.
            EXPECT_EQ(double(sample.x), pencil.x0 + x);
            EXPECT_EQ(double(sample.y), pencil.y0 + y);
            EXPECT_EQ(std::floor(2 * sample.x), 2 * sample.x);
            EXPECT_EQ(std::floor(2 * sample.y), 2 * sample.y);

            const glm::dvec3 d =
                made.ray(region.x + (x + 0.5) / samples, region.y + (y + 0.5) / samples);
            const glm::dvec3 in_eye_space = pencil.eye_from_world * d;
            EXPECT_NEAR(in_eye_space.x, sample.x, 1e-9);
            EXPECT_NEAR(in_eye_space.y, sample.y, 1e-9);
            EXPECT_NEAR(in_eye_space.z, 1, 1e-12);

            const glm::dvec2 step = glm::dvec2(sample) / pencil.f;
            EXPECT_LT(glm::length(pencil.world_from_axes * glm::dvec3(step, 1) - d), 1e-12);
            const glm::dvec3 in_frame(
                step.x + step.y * pencil.shear.x + pencil.shear.y, step.y + pencil.shear.z, 1);
            EXPECT_NEAR(glm::length(in_frame), glm::length(d), 1e-12);

            const glm::vec3 as_floats = rays.right * (sample.x * rays.step_x) +
                                        rays.down * (sample.y * rays.step_y) + rays.forward;
            EXPECT_LT(glm::length(glm::dvec3(as_floats) - d), 1e-6 * glm::length(d));
        }
    }
}

TEST(Pencil, IsNotShearedByAPrincipalPointAtHalfSamples)
{
    Calibrated made;
    made.view.camera.focal = glm::dvec2(500, 400);
    for (const double half : {-3.5, 0.0, 100.5, 101.0}) {
        made.view.camera.principal_point = glm::dvec2(half, 7);
        const Pencil pencil = pencil_of(made.view, {0, 0, 8, 8}, 1);
        EXPECT_EQ(pencil.shear, glm::dvec3(0));
        EXPECT_EQ(pencil.x0, 0.5 - half);
        EXPECT_EQ(pencil.y0, 0.5 - 7);
    }
}

TEST(Pencil, OfTheSameFocalLengthsInTheMiddleIsThatOfTheFieldOfView)
{
    Calibrated made;
    const Pencil expected = pencil_of(made.view, {3, 5, 40, 30}, 2);
    made.view.camera.focal =
        glm::dvec2(0.5 * made.view.height / std::tan(0.5 * made.view.camera.fov_y_rad));
    made.view.camera.fov_y_rad = std::numeric_limits<double>::quiet_NaN(); // not looked at
    made.view.camera.principal_point = glm::dvec2(320, 241);
    const Pencil pencil = pencil_of(made.view, {3, 5, 40, 30}, 2);
    EXPECT_EQ(pencil.eye_from_world, expected.eye_from_world);
    EXPECT_EQ(pencil.world_from_axes, expected.world_from_axes);
    EXPECT_EQ(pencil.f, expected.f);
    EXPECT_EQ(pencil.x0, expected.x0);
    EXPECT_EQ(pencil.y0, expected.y0);
}

TEST(Pencil, OfAnyRangeIsRefusedWithTheReason)
{
    const auto refused = [](const char* about, const std::function<void(Camera&)>& change) {
        Calibrated made;
        change(made.view.camera);
        const std::string message = message_of<ArgumentError>([&] {
            pencil_of(made.view, {0, 0, 8, 8}, 2);
        });
        EXPECT_NE(message.find(about), std::string::npos) << message;
    };
    const double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, nan, inf, 1e-13, 1e15}) {
        refused("focal lengths", [&](Camera& c) { c.focal = glm::dvec2(bad, 100); });
        refused("focal lengths", [&](Camera& c) { c.focal = glm::dvec2(100, bad); });
    }
    for (const double bad : {nan, inf, -inf, 131073.0, -131073.0}) {
        refused("principal point", [&](Camera& c) { c.principal_point = glm::dvec2(bad, 0); });
        refused("principal point", [&](Camera& c) { c.principal_point = glm::dvec2(0, bad); });
    }
    for (const double bad : {nan, inf, -inf, 1e5 + 1, -1e5 - 1})
        refused("skew", [&](Camera& c) { c.focal = glm::dvec2(100, 90), c.skew = bad; });
}

TEST(Rays, TransformedAreWhereTheMatrixSays)
{
    std::mt19937 random(5);
    const glm::dmat3 matrix(2, 0.5, -1, 0.25, 3, 1, -2, 1, 0.5);
    const glm::dvec3 origin(1, -2, 3), offset(4, 5, -6);
    for (int round = 0; round < 50; ++round) {
        const Calibrated made = random_camera(random);
        const Pencil pencil = pencil_of(made.view, {0, 0, 640, 480}, 1);
        const int x = round * 10, y = round * 7;
        const Rays tile = world_rays(pencil, pencil.tile(x, y)),
                   to = transformed(tile, matrix, origin, offset);
        EXPECT_EQ(to.lattice().direction(0, 0), tile.lattice().direction(0, 0));
        EXPECT_EQ(to.step_x, 1);
        EXPECT_EQ(to.step_y, 1);
        const glm::dvec3 p = made.view.camera.eye + 8.0 * made.ray(x + 3.5, y + 5.5);
        const glm::dvec3 expected = matrix * (p - origin) + offset;
        const glm::vec3 seen =
            to.eye + 8.0f * ((to.x0 + 3.0f) * to.right + (to.y0 + 5.0f) * to.down + to.forward);
        EXPECT_LT(glm::length(glm::dvec3(seen) - expected), 1e-4);
    }
}

} // namespace
} // namespace firsthit::test
