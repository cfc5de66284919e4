// camera_options_test.cpp - parts of a camera replaced from the command line.
#include "options/camera_options.h"
#include "common/usage.h"

#include "message_of.h"

#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

const Camera kCamera{.eye = {0, 0, 5}, .direction = {0, 0, -2}, .up = {0, 1, 0}, .fov_y_rad = 1.0};

TEST(CameraOptions, NothingGivenIsTheSameCamera)
{
    const Camera camera = override_camera(kCamera, {}, {});
    EXPECT_EQ(camera.eye, kCamera.eye);
    EXPECT_EQ(camera.direction, kCamera.direction);
    EXPECT_EQ(camera.up, kCamera.up);
    EXPECT_EQ(camera.fov_y_rad, kCamera.fov_y_rad);
}

TEST(CameraOptions, TheEyeAloneMovesTheScenesCameraWithoutTurningIt)
{
    CameraOptions options;
    options.eye = glm::dvec3(1, 2, 3);
    const Camera camera = override_camera(kCamera, options, {});
    EXPECT_EQ(camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(camera.direction, kCamera.direction);
}

TEST(CameraOptions, TheEyeAloneLooksAtTheMiddleOfASceneWithoutACamera)
{
    CameraOptions options;
    options.eye = glm::dvec3(1, 2, 3);
    EXPECT_EQ(
        override_camera(kCamera, options, glm::dvec3(1, 0, 0)).direction, glm::dvec3(0, -2, -3));
}

TEST(CameraOptions, AtTurnsTheCameraFromWhereverItIs)
{
    CameraOptions options;
    options.at = glm::dvec3(1, 0, 0);
    EXPECT_EQ(override_camera(kCamera, options, {}).direction, glm::dvec3(1, 0, -5));
    options.eye = glm::dvec3(1, 0, 9);
    EXPECT_EQ(override_camera(kCamera, options, glm::dvec3(7)).direction, glm::dvec3(0, 0, -9));
}

TEST(CameraOptions, LookingStraightDownHasMinusZAsUp)
{
    CameraOptions options;
    options.eye = glm::dvec3(0, 10, 0);
    options.at = glm::dvec3(0, 0, 0);
    EXPECT_EQ(override_camera(kCamera, options, {}).up, glm::dvec3(0, 0, -1));
}

TEST(CameraOptions, TheAngleAndUpAreTaken)
{
    CameraOptions options;
    options.up = glm::dvec3(1, 0, 0);
    options.fov_y_rad = 0.5;
    const Camera camera = override_camera(kCamera, options, {});
    EXPECT_EQ(camera.up, glm::dvec3(1, 0, 0));
    EXPECT_EQ(camera.fov_y_rad, 0.5);
}

TEST(CameraOptions, AnEyeAtThePointItLooksAtIsAnError)
{
    CameraOptions options;
    options.eye = options.at = glm::dvec3(1, 2, 3);
    EXPECT_EQ(message_of<UsageError>([&] { override_camera(kCamera, options, {}); }),
        "the eye and the point that it looks at coincide: move --eye or --at");
}

TEST(CameraOptions, AnUpAlongTheDirectionIsAnError)
{
    CameraOptions options;
    options.up = glm::dvec3(0, 0, 1);
    EXPECT_EQ(message_of<UsageError>([&] { override_camera(kCamera, options, {}); }),
        "--up is parallel to the direction of view: choose another");
    options.up = glm::dvec3(0);
    EXPECT_THROW(override_camera(kCamera, options, {}), UsageError);
}

} // namespace
} // namespace firsthit::cli
