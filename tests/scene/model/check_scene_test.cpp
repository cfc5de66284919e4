// check_scene_test.cpp - a scene that breaks a promise is refused, and the element is named.
#include "scene/model/check_light.h"
#include "scene/model/check_scene.h"

#include "message_of.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace firsthit {
namespace {

Scene square_scene()
{
    return scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}},
        std::vector<glm::vec3>(4, {0, 0, 1}), std::vector<glm::vec2>(4, {0, 0}));
}

/// What check_scene says of a square after `damage`.
template <class Damage>
std::string message_after(const Damage& damage)
{
    Scene scene = square_scene();
    damage(scene);
    return message_of<SceneError>([&] { check_scene(scene); });
}

TEST(CheckScene, AcceptsASoundScene)
{
    EXPECT_NO_THROW(check_scene(square_scene()));
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
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].first_triangle = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].triangle_count = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].triangle_count = 3; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].vertex_count = 5; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].first_vertex = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].node = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].material = 1; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].morph.resize(1); }), "no error");
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
    EXPECT_NE(message_after([](Scene& s) { s.nodes[0].local[3][0] = std::nan(""); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.cameras.push_back({.node = 1}); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.lights[0].node = 3; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].shape = 0; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.instances[0].skin = 0; }), "no error");
    EXPECT_NE(message_after([](Scene& s) { s.lights[0].color.g = std::nanf(""); }), "no error");
    EXPECT_NE(message_after([](Scene& s) { std::get<Phong>(s.materials[0].model).texture = 0; }),
        "no error");
    EXPECT_NE(message_after([](Scene& s) {
        std::get<Phong>(s.materials[0].model).diffuse.b = std::nanf("");
    }),
        "no error");
}

TEST(CheckScene, NamesAMaterialWhoseOpacityIsNotSound)
{
    const auto names_material = [](const auto& damage) {
        const std::string message = message_after([&](Scene& s) { damage(s.materials[0]); });
        return message.find("material 0") != std::string::npos;
    };
    EXPECT_FALSE(names_material([](Material& m) { m.alpha = AlphaMode::mask; }));
    EXPECT_TRUE(names_material([](Material& m) { m.opacity = std::nanf(""); }));
    EXPECT_TRUE(names_material([](Material& m) { m.alpha_cutoff = std::nanf(""); }));
    EXPECT_TRUE(names_material([](Material& m) { m.opacity_texture.texture = 0; }));
    EXPECT_TRUE(names_material([](Material& m) { m.opacity_texture.uv_set = 2; }));
    EXPECT_TRUE(
        names_material([](Material& m) { m.opacity_texture.transform[2].y = std::nanf(""); }));
}

TEST(CheckScene, RefusesSharesOfMaterialsBeyondZeroToOne)
{
    const auto message = [](const auto& damage) {
        return message_after([&](Scene& s) {
            s.materials[0].name = "m";
            s.materials[0].model = MetallicRoughness{};
            damage(s.materials[0]);
        });
    };
    const auto model = [](Material& m) -> MetallicRoughness& {
        return std::get<MetallicRoughness>(m.model);
    };
    EXPECT_EQ(message([](Material& m) { m.opacity = 2; }),
        "arrays: material 0 'm': opacity is 2: accepted is 0 to 1");
    EXPECT_EQ(message([&](Material& m) { model(m).roughness = -1; }),
        "arrays: material 0 'm': roughness is -1: accepted is 0 to 1");
    EXPECT_EQ(message([&](Material& m) { model(m).metallic = 1.5f; }),
        "arrays: material 0 'm': metallic is 1.5: accepted is 0 to 1");
    for (const float end : {0.0f, 1.0f})
        EXPECT_EQ(
            message([&](Material& m) { m.opacity = model(m).roughness = model(m).metallic = end; }),
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

/// A scene whose clip "walk" has one channel that is sound before `change`.
std::string message_of_channel(const std::function<void(Channel&)>& change)
{
    return message_after([&](Scene& s) {
        s.nodes[0].transform.emplace();
        Clip& clip = s.clips.emplace_back();
        clip.name = "walk";
        Channel& channel = clip.channels.emplace_back();
        channel.path = Channel::Path::rotation;
        channel.time_s = {0, 1};
        channel.value = {0, 0, 0, 1, 0, 0, 0, 1};
        change(channel);
    });
}

TEST(CheckScene, NamesTheChannelThatIsNotSound)
{
    const std::string what = "arrays: clip 'walk': rotation of node 0 'arrays'";
    EXPECT_EQ(message_of_channel([](Channel&) {}), "no error");
    EXPECT_EQ(message_of_channel([](Channel& c) {
        c.interpolation = Channel::Interpolation::tcb;
        c.tcb.resize(4);
        c.tcb[2].value.y = std::nan("");
    }),
        what + " key 2 is not finite");
    EXPECT_EQ(message_of_channel([](Channel& c) { c.value.pop_back(); }),
        what + ": 7 numbers for 2 keys");
    EXPECT_EQ(
        message_of_channel([](Channel& c) { c.interpolation = Channel::Interpolation::cubic; }),
        what + ": 8 numbers for 2 keys");
    EXPECT_EQ(message_of_channel([](Channel& c) {
        c.time_s = {1, 0};
    }),
        what + ": the time of key 1 is before that of the one before");
    EXPECT_EQ(message_of_channel([](Channel& c) { c.value[3] = std::nan(""); }),
        what + ": a value is not finite");
    EXPECT_EQ(message_of_channel([](Channel& c) { c.time_s.clear(); }), what + ": no key");
    EXPECT_EQ(message_of_channel([](Channel& c) { c.node = 1; }),
        "arrays: clip 'walk': channel 0: node 1 is out of range (1)");
    EXPECT_EQ(message_after([](Scene& s) {
        s.clips.push_back({.name = "walk",
            .channels = {
                {.path = Channel::Path::scale, .time_s = {0}, .value = {1, 1, 1}, .tcb = {}}}});
    }),
        "arrays: clip 'walk': scale of node 0 'arrays': the node has a matrix and no transform "
        "that "
        "could change");
    EXPECT_EQ(message_after([](Scene& s) {
        s.nodes[0].transform.emplace();
        Channel channel{.path = Channel::Path::scale, .time_s = {0}, .value = {1, 1, 1}, .tcb = {}};
        s.clips.push_back({.name = "walk", .channels = {channel, channel}});
    }),
        "arrays: clip 'walk': scale of node 0 'arrays': a second channel");
}

TEST(CheckScene, NamesSkinsAndWeightsThatAreNotSound)
{
    const auto skinned = [](const std::function<void(Scene&)>& change) {
        return message_after([&](Scene& s) {
            s.skins.push_back({"bones", {0}, {glm::dmat4(1)}});
            s.shapes.resize(1);
            SkinWeights& skin = s.shapes[0].skin;
            skin.influences = 1;
            skin.joint.assign(s.vertices, 0);
            skin.weight.assign(s.vertices, 1.0f);
            s.instances[0].shape = 0;
            s.instances[0].skin = 0;
            change(s);
        });
    };
    EXPECT_EQ(skinned([](Scene&) {}), "no error");
    EXPECT_EQ(skinned([](Scene& s) { s.shapes[0].skin.joint[1] = 1; }),
        "arrays: instance 0 'arrays': vertex 1: joint 1 is out of range (1)");
    EXPECT_NE(skinned([](Scene& s) { s.shapes[0].skin.weight.pop_back(); }), "no error");
    EXPECT_NE(skinned([](Scene& s) { s.shapes[0].skin.weight[0] = std::nanf(""); }), "no error");
    EXPECT_EQ(skinned([](Scene& s) { s.skins[0].joints[0] = 5; }),
        "arrays: skin 0 'bones': joint 0: node 5 is out of range (1)");
    EXPECT_EQ(skinned([](Scene& s) { s.skins[0].inverse_bind.clear(); }),
        "arrays: skin 0 'bones' has 0 inverse bind matrices for 1 joints");
    EXPECT_NE(
        skinned([](Scene& s) { s.skins[0].inverse_bind[0][3][1] = std::nan(""); }), "no error");
    EXPECT_NE(skinned([](Scene& s) {
        s.shapes[0].targets.push_back({"smile", {{1, 2, 3}}, {}, {}});
    }),
        "no error");
}

} // namespace
} // namespace firsthit
