// camera_options_test.cpp - parts of a camera replaced from the command line.
#include "options/camera_options.h"
#include "common/usage.h"

#include "message_of.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

TEST(CameraOptions, ViewsAndAxesHaveNames)
{
    EXPECT_EQ(parse_view("top"), NamedView::top);
    EXPECT_EQ(message_of<UsageError>([] { parse_view("up"); }),
        "'up' is no view: accepted are iso, front, back, left, right, top and bottom");
    EXPECT_EQ(parse_axis("-z"), glm::dvec3(0, 0, -1));
    EXPECT_EQ(parse_axis("x"), glm::dvec3(1, 0, 0));
    for (const char* text : {"", "-", "w", "--x", "xx"}) EXPECT_THROW(parse_axis(text), UsageError);
}

TEST(CameraOptions, TheKindOfFileSaysWhatIsUp)
{
    EXPECT_EQ(usual_up_axis("a/b.STL"), glm::dvec3(0, 0, 1));
    EXPECT_EQ(usual_up_axis("b.ply"), glm::dvec3(0, 0, 1));
    EXPECT_EQ(usual_up_axis("b.stl/c.glb"), glm::dvec3(0, 1, 0));
    EXPECT_EQ(usual_up_axis("builtin:torus"), glm::dvec3(0, 1, 0));
}

TEST(CameraOptions, IntrinsicsAndRegionsAreNumbers)
{
    EXPECT_EQ(parse_intrinsics("800,810,320,240"), (std::array<double, 5>{800, 810, 320, 240, 0}));
    EXPECT_EQ(parse_intrinsics("800,810,320.5,240,-3")[4], -3);
    for (const char* text : {"", "800", "800,800,3", "0,800,320,240", "800,-1,320,240",
             "800,800,nan,240", "800,800,320,240,0,0", "a,b,c,d"})
        EXPECT_NE(message_of<UsageError>([&] {
            parse_intrinsics(text);
        }).find("accepted are fx,fy,cx,cy"),
            std::string::npos)
            << text;
    const Region region = parse_region("1,2,30,40");
    EXPECT_EQ(region.x, 1);
    EXPECT_EQ(region.height, 40);
    for (const char* text :
        {"", "1,2,3", "-1,0,3,3", "0,0,0,3", "0,0,3,0", "0.5,0,3,3", "0,0,1e9,3", "nan,0,1,1"})
        EXPECT_THROW(parse_region(text), UsageError) << text;
}

/// A world of one triangle, without a camera of its own.
World triangle_world()
{
    World world;
    pose(scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}), 0, world);
    return world;
}

TEST(ViewMaker, ZoomsByTheAngle)
{
    World world = triangle_world();
    CameraOptions options;
    const Camera whole = ViewMaker(options, "a.obj").view(world).camera;
    options.zoom = 4;
    const Camera zoomed = ViewMaker(options, "a.obj").view(world).camera;
    EXPECT_EQ(zoomed.eye, whole.eye);
    EXPECT_NEAR(4 * std::tan(zoomed.fov_y_rad / 2), std::tan(whole.fov_y_rad / 2), 1e-12);
}

TEST(ViewMaker, ACalibratedLensMovesByItsPixelsCentres)
{
    World world = triangle_world();
    CameraOptions options;
    options.intrinsics = {700, 710, 320, 240, 2};
    const Camera ours = ViewMaker(options, "a.obj").view(world).camera;
    EXPECT_EQ(ours.focal, glm::dvec2(700, 710));
    EXPECT_EQ(ours.principal_point, glm::dvec2(320, 240));
    EXPECT_EQ(ours.skew, 2);
    options.pixel_center = 0;
    EXPECT_EQ(
        ViewMaker(options, "a.obj").view(world).camera.principal_point, glm::dvec2(320.5, 240.5));
}

TEST(ViewMaker, TakesTheCamerasOfAFileInTurn)
{
    World world = triangle_world();
    CameraOptions options;
    options.cameras = {{.name = "a", .camera = kCamera, .width = 40, .height = 30},
        {.name = "b", .camera = {.eye = {7, 8, 9}}, .width = 50, .height = 60}};
    ViewMaker views(options, "a.obj");
    EXPECT_EQ(views.view(world, 0).camera.eye, kCamera.eye);
    EXPECT_EQ(views.view(world, 0).width, 40);
    const View second = views.view(world, 1);
    EXPECT_EQ(second.camera.eye, glm::dvec3(7, 8, 9));
    EXPECT_EQ(second.height, 60);
}

TEST(ViewMaker, GoesRoundTheMiddleWithTheLight)
{
    World world = triangle_world();
    CameraOptions options;
    options.turntable = 4;
    ViewMaker views(options, "a.obj");
    const glm::dvec3 middle(0.5, 1, 0);
    const Camera first = views.view(world, 0).camera;
    const glm::dvec3 shines = world.lights[0].direction;
    const Camera third = views.view(world, 2).camera;
    EXPECT_NEAR(glm::length(third.eye - middle), glm::length(first.eye - middle), 1e-12);
    EXPECT_NEAR(third.eye.y, first.eye.y, 1e-12);
    EXPECT_LT(glm::length(third.eye - middle + (first.eye - middle) * glm::dvec3(1, -1, 1)), 1e-12);
    EXPECT_LT(glm::length(world.lights[0].direction + shines * glm::dvec3(1, -1, 1)), 1e-12);
}

TEST(ViewMaker, KeepsAScenesOwnCameraUnlessAViewIsAskedFor)
{
    Scene scene = scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}});
    scene.cameras = {{.camera = kCamera}};
    World world;
    pose(std::move(scene), 0, world);
    CameraOptions options;
    EXPECT_EQ(ViewMaker(options, "a.obj").view(world).camera.eye, kCamera.eye);
    options.view = NamedView::back;
    EXPECT_LT(ViewMaker(options, "a.obj").view(world).camera.eye.z, 0);
}

} // namespace
} // namespace firsthit::cli
