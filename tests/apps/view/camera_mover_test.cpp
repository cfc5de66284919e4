// camera_mover_test.cpp - a camera that a hand moves keeps what it looks at, and is spelled as options.
#include "view/session/camera_mover.h"

#include "common/parse.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace firsthit::cli::view {
namespace {

const Box kBox{glm::dvec3(-1, -2, -3), glm::dvec3(3, 2, 1)};

CameraMover taken()
{
    Camera camera;
    camera.eye = {4, 3, 12};
    camera.direction = glm::dvec3(1, 0, -1) - camera.eye;
    CameraMover mover;
    mover.take(camera, kBox, {0, 1, 0}, 720);
    return mover;
}

/// Where a point is in the picture, as a share of its height from the middle.
glm::dvec2 seen(const Camera& camera, const glm::dvec3& p)
{
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward), v = p - camera.eye;
    const double height = 2 * glm::dot(v, forward) * std::tan(camera.fov_y_rad / 2);
    return {glm::dot(v, right) / height, -glm::dot(v, up) / height};
}

TEST(CameraMover, TakesOverWhatTheCameraShowed)
{
    const Camera camera = taken().camera();
    EXPECT_EQ(camera.eye, glm::dvec3(4, 3, 12));
    const glm::dvec3 wanted = glm::normalize(glm::dvec3(1, 0, -1) - camera.eye);
    EXPECT_NEAR(glm::dot(glm::normalize(camera.direction), wanted), 1, 1e-12);
    EXPECT_NEAR(camera.fov_y_rad, Camera{}.fov_y_rad, 1e-12);
}

TEST(CameraMover, OrbitKeepsDistanceAndMiddle)
{
    CameraMover mover = taken();
    const Camera before = mover.camera();
    const glm::dvec3 at = before.eye + before.direction;
    mover.orbit(0.7, -0.3);
    const Camera after = mover.camera();
    EXPECT_NEAR(glm::length(after.direction), glm::length(before.direction), 1e-9);
    EXPECT_NEAR(glm::length(after.eye + after.direction - at), 0, 1e-9);
}

TEST(CameraMover, InsideOfASceneItTurnsAboutWhatIsSeen)
{
    const Box wide{glm::dvec3(-100, -1, -100), glm::dvec3(100, 1, 100)};
    for (const Box& box : {wide, kBox}) {
        CameraMover mover = taken();
        const Camera before = mover.camera();
        mover.focus(2.5, box);
        const bool inside = box == wide; // else the whole is seen from outside, and turned
        EXPECT_NEAR(mover.distance(), inside ? 2.5 : glm::length(before.direction), 1e-9);
        EXPECT_NEAR(
            glm::dot(glm::normalize(mover.camera().direction), glm::normalize(before.direction)), 1,
            1e-12);
    }
}

TEST(CameraMover, OrbitStopsAtThePoles)
{
    for (const double way : {1.0, -1.0}) {
        CameraMover mover = taken();
        for (int k = 0; k < 100; ++k) mover.orbit(0.1, way * 0.3);
        const glm::dvec3 forward = glm::normalize(mover.camera().direction);
        EXPECT_LT(std::abs(forward.y), 0.9999);
        EXPECT_GT(std::abs(forward.y), 0.99);
        EXPECT_EQ(forward.y<0, way> 0) << "up is up";
    }
}

TEST(CameraMover, ZoomKeepsWhatIsUnderThePointer)
{
    CameraMover mover = taken();
    const Camera before = mover.camera();
    const glm::dvec2 pointer(0.31, -0.22);
    const glm::dvec3 forward = glm::normalize(before.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, before.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double height = 2 * glm::length(before.direction) * std::tan(before.fov_y_rad / 2);
    const glm::dvec3 p =
        before.eye + before.direction + (right * pointer.x - up * pointer.y) * height;
    for (const double factor : {0.9, 0.5, 1.7}) {
        mover.zoom(factor, pointer);
        const glm::dvec2 now = seen(mover.camera(), p);
        EXPECT_NEAR(now.x, pointer.x, 1e-9);
        EXPECT_NEAR(now.y, pointer.y, 1e-9);
    }
}

TEST(CameraMover, PanMovesWhatIsInTheMiddleWithThePointer)
{
    CameraMover mover = taken();
    const Camera before = mover.camera();
    const glm::dvec3 middle = before.eye + before.direction;
    mover.pan({0.1, 0.2});
    const glm::dvec2 now = seen(mover.camera(), middle);
    EXPECT_NEAR(now.x, 0.1, 1e-9);
    EXPECT_NEAR(now.y, 0.2, 1e-9);
}

TEST(CameraMover, FrameShowsAllOfABox)
{
    for (const double aspect : {0.4, 1.0, 2.5}) {
        CameraMover mover = taken();
        mover.frame(kBox, {1, 2, 3}, {0, 1, 0}, aspect);
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 corner(kBox[k & 1].x, kBox[(k >> 1) & 1].y, kBox[(k >> 2) & 1].z);
            const glm::dvec2 at = seen(mover.camera(), corner);
            EXPECT_LT(std::abs(at.x), 0.5 * aspect);
            EXPECT_LT(std::abs(at.y), 0.5);
        }
    }
}

TEST(CameraMover, OptionsSayTheCameraToTheBit)
{
    CameraMover mover = taken();
    mover.orbit(0.123, 0.0456);
    mover.pan({0.017, -0.03});
    std::istringstream words(mover.as_options());
    std::string name, value;
    glm::dvec3 eye(0), at(0), up(0);
    double fov = 0;
    while (words >> name >> value) {
        if (name == "--eye") eye = parse_vector(value);
        if (name == "--at") at = parse_vector(value);
        if (name == "--up") up = parse_vector(value);
        if (name == "--fov") fov = parse_fov(value);
    }
    const Camera camera = mover.camera();
    EXPECT_EQ(camera.eye, eye);
    EXPECT_EQ(camera.direction, at - eye);
    EXPECT_EQ(camera.up, up);
    EXPECT_EQ(camera.fov_y_rad, fov);
}

} // namespace
} // namespace firsthit::cli::view
