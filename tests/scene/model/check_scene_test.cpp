// check_scene_test.cpp - a scene that breaks a promise is refused, and the element is named.
#include "scene/model/check_light.h"
#include "scene/model/check_scene.h"

#include "message_of.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace firsthit {
namespace {

Scene square()
{
    return scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}},
        std::vector<glm::vec3>(4, {0, 0, 1}), std::vector<glm::vec2>(4, {0, 0}));
}

/// What check_scene says of a square after `damage`.
template <class Damage>
std::string message_after(const Damage& damage)
{
    Scene scene = square();
    damage(scene);
    return message_of<SceneError>([&] { check_scene(scene); });
}

TEST(CheckScene, AcceptsASoundScene)
{
    EXPECT_NO_THROW(check_scene(square()));
    EXPECT_NO_THROW(check_scene(Scene{}));
}

TEST(CheckScene, NamesACoordinateThatIsNotFinite)
{
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(message_after([](Scene& s) { s.position[2].y = std::nanf(""); }),
        "arrays: vertex 2: y is nan, not a finite number");
    EXPECT_EQ(message_after([&](Scene& s) { s.normal[3].z = -inf; }),
        "arrays: normal 3: z is -inf, not a finite number");
    EXPECT_EQ(message_after([&](Scene& s) { s.uv[1].x = inf; }),
        "arrays: texture coordinate 1: x is inf, not a finite number");
}

TEST(CheckScene, FindsTheLastCoordinateOfMany)
{
    std::vector<glm::vec3> position(100'003, glm::vec3(1));
    Scene scene = scene_from_arrays(position, {{0, 1, 2}}, position);
    scene.position.back().z = std::nanf("");
    EXPECT_EQ(message_of<SceneError>([&] { check_scene(scene); }),
        "arrays: vertex 100002: z is nan, not a finite number");
}

TEST(CheckScene, NamesATriangleWhoseVertexIsOutOfRange)
{
    EXPECT_NE(
        message_after([](Scene& s) { s.index[1].z = 4; }).find("triangle 1"), std::string::npos);
    EXPECT_NE(
        message_after([](Scene& s) { s.owner[1] = 1; }).find("its owner is 1"), std::string::npos);
}

TEST(CheckScene, RefusesPartsWithGapsOrBeyondTheEnd)
{
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].first_triangle = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].triangle_count = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].triangle_count = 3; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].vertex_count = 5; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].first_vertex = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].node = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].material = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.parts[0].morph.resize(1); }), "no error");
}

TEST(CheckScene, RefusesArraysOfOtherLengths)
{
    EXPECT_NE(message_after([](Scene& s) { s.normal.pop_back(); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.uv.pop_back(); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.owner.pop_back(); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.position.clear(); }), "no error");
    EXPECT_EQ(message_after([](Scene& s) { s.uv.clear(); }), "no error");
}

TEST(CheckScene, RefusesParentsThatComeLaterAndNumbersOutOfRange)
{
    EXPECT_NE(
        message_after([](Scene& s) { s.nodes[0].parent = 0; }).find("parent 0"), std::string::npos);
    EXPECT_NE(message_after([](Scene& s) { s.nodes[0].parent = -2; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.nodes[0].track = 0; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.nodes[0].local[3][0] = std::nan(""); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.camera_track = 0; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.lights[0].track = 3; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.lights[0].color.g = std::nanf(""); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { std::get<Phong>(s.materials[0].model).texture = 0; }),
        "no error");
    EXPECT_NE(message_after([](Scene& s) {
        std::get<Phong>(s.materials[0].model).diffuse.b = std::nanf("");
    }),
        "no error");
}

TEST(CheckScene, NamesALightAndWhatItAccepts)
{
    EXPECT_EQ(message_after([](Scene& s) {
        s.lights.resize(3);
        s.lights[2].kind = Light::Kind::directional;
        s.lights[2].direction = {0, 0, 0};
    }),
        "arrays: light 2: its direction (0, 0, 0) is none: accepted is a length from 1e-100 to "
        "1e+100");
    EXPECT_EQ(message_after([](Scene& s) {
        s.lights[0].kind = Light::Kind::spot;
        s.lights[0].inner_rad = 0.5;
        s.lights[0].outer_rad = 0.25;
    }),
        "arrays: light 0: its cone of half angles 0.5 and 0.25 rad is none: accepted are 0 <= "
        "inner "
        "<= outer, and outer above 0 and below pi / 2");
    EXPECT_EQ(message_after([](Scene& s) {
        s.lights[0].position.y = std::nan("");
    }).rfind("arrays: light 0: its position", 0),
        0u);
}

TEST(CheckLight, RefusesEveryValueOutOfRangeThatItsKindAsksFor)
{
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const auto spot = [](double inner, double outer) {
        return fault_of({.kind = Light::Kind::spot, .inner_rad = inner, .outer_rad = outer});
    };
    EXPECT_EQ(spot(0, 1e-6), "");
    EXPECT_EQ(spot(0.5, 0.5), "");
    EXPECT_EQ(spot(0, 1.5707), "");
    EXPECT_NE(spot(0, 0), "");
    EXPECT_NE(spot(0, 1.5708), "");
    EXPECT_NE(spot(-0.1, 1), "");
    EXPECT_NE(spot(0, nan), "");
    EXPECT_NE(spot(nan, 1), "");
    EXPECT_NE(spot(0, inf), "");
    for (const glm::dvec3& direction : {glm::dvec3(0), glm::dvec3(0, nan, 1), glm::dvec3(inf, 0, 0),
             glm::dvec3(1e-300, 0, 0), glm::dvec3(0, 1e200, 0)}) {
        EXPECT_NE(fault_of({.kind = Light::Kind::spot, .direction = direction}), "");
        EXPECT_NE(fault_of({.kind = Light::Kind::directional, .direction = direction}), "");
        EXPECT_EQ(fault_of({.kind = Light::Kind::point, .direction = direction}), "");
    }
}

TEST(CheckScene, RefusesATrackKeyThatIsNotFinite)
{
    const std::string message = message_after([](Scene& s) {
        s.tracks.resize(1);
        s.tracks[0].name = "walk";
        s.tracks[0].rotation.resize(4);
        s.tracks[0].rotation[2].value.y = std::nan("");
    });
    EXPECT_EQ(message, "arrays: track 'walk': rotation key 2 is not finite");
}

} // namespace
} // namespace firsthit
