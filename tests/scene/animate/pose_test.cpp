// pose_test.cpp - scenes at times.
#include "scene/animate/pose.h"

#include "message_of.h"
#include "readers/aff/aff_text.h"
#include "scene/model/borrow.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace firsthit {
namespace {

World posed(const Scene& scene, double time_s, int threads = 1)
{
    World world;
    pose(borrow(scene), time_s, world, threads);
    return world;
}

std::string track_text(const std::string& name, const glm::dvec3& from, const glm::dvec3& to)
{
    const auto at = [](double t, const glm::dvec3& p) {
        return std::to_string(t) + " " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
               std::to_string(p.z) + " 0 0 0 ";
    };
    return "k " + name + " { transl 4 " + at(0, from) + at(0, from) + at(1, to) + at(1, to) + "} ";
}

/// An instance of n deforming vertices: vertex v is at (v, time, 0).
Scene deforming(std::uint32_t n)
{
    Scene scene;
    scene.nodes.resize(1);
    scene.materials.resize(1);
    scene.instances.resize(1);
    scene.instances[0].vertex_count = n;
    scene.vertices = n;
    scene.instances[0].deform = [](double time_s, std::size_t first, std::size_t last,
                                    glm::vec3* position, glm::vec3* normal) {
        for (std::size_t v = first; v < last; ++v) {
            position[v - first] = {float(v), float(time_s), 0};
            normal[v - first] = {0, 0, 1};
        }
    };
    return scene;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Pose, MovesNodesInsideNodes)
{
    const Scene scene = scene_of("x outer{xs 2 2 2 0 0 1 90 1 0 0{" + kTriangle + "}}" +
                                 track_text("outer", {0, 0, 0}, {10, 0, 0}));
    const World world = posed(scene, 1);
    // (1, 0, 0): scaled (2, 0, 0), turned (0, 2, 0), moved (1, 2, 0), and by the track (11, 2, 0).
    EXPECT_NEAR(glm::distance(world.position[1], glm::vec3(11, 2, 0)), 0, 1e-6);
    EXPECT_EQ(world.time_s, 1);
    EXPECT_EQ(world.scene.get(), &scene);
    EXPECT_EQ(world.node_matrix[2][3], glm::dvec4(11, 0, 0, 1));
}

TEST(Pose, KeepsNormalsAtRightAnglesUnderUnevenScale)
{
    const Scene scene = scene_of("xs 1 5 1 0 0 1 30 0 0 0{p 3 0 0 0 1 1 0 0 0 1}");
    const World world = posed(scene, 0);
    for (const glm::vec3& n : world.normal) {
        EXPECT_NEAR(glm::length(n), 1, 1e-6);
        EXPECT_NEAR(glm::dot(n, world.position[1] - world.position[0]), 0, 1e-6);
        EXPECT_NEAR(glm::dot(n, world.position[2] - world.position[0]), 0, 1e-6);
    }
}

TEST(Pose, KeepsNormalsOutsideUnderMirrors)
{
    const Scene scene = scene_of("xs -1 1 1 0 0 0 0 0 0 0{s 0 0 0 1}");
    const World world = posed(scene, 0);
    for (std::size_t v = 0; v < world.position.size(); ++v)
        EXPECT_GT(glm::dot(world.position[v], world.normal[v]), 0.99f);
}

TEST(Pose, KeepsUnitNormalsWhereNodesAreSquashedOrTiny)
{
    for (const char* scale : {"1 1 0", "1 0 0", "0 0 0", "1e-30 1e-30 1e-30", "1e30 1e-30 1"}) {
        const Scene scene = scene_of("xs " + std::string(scale) + " 0 0 0 0 0 0 0{s 0 0 0 1}");
        for (const glm::vec3& n : posed(scene, 0).normal)
            ASSERT_NEAR(glm::dot(n, n), 1, 1e-5) << scale;
    }
}

TEST(Pose, KeepsTheNormalOfAPlaneThatIsSquashedIntoItself)
{
    const Scene scene = scene_of("xs 1 1 0 0 0 0 0 0 0 0{" + kTriangle + "}");
    EXPECT_EQ(posed(scene, 0).normal[0], glm::vec3(0, 0, 1));
}

TEST(Pose, CollapsesInvisibleNodesAndAllBelowToAPoint)
{
    const Scene scene =
        scene_of("x a{x b{" + kTriangle + "}}k a{visibility 1 1 0 " +
                 track_text("", {5, 6, 7}, {5, 6, 7}).substr(4) + " k b{visibility 1 0 1}");
    const World seen = posed(scene, 0.5);
    EXPECT_NE(seen.position[0], seen.position[1]);
    EXPECT_TRUE(seen.node_visible[2]);
    const World hidden = posed(scene, 1);
    for (const glm::vec3& p : hidden.position) EXPECT_EQ(p, glm::vec3(5, 6, 7));
    EXPECT_FALSE(hidden.node_visible[1]);
    EXPECT_FALSE(hidden.node_visible[2]);
}

TEST(Pose, BlendsShapesBetweenTheirKeysAndHoldsThemOutside)
{
    const Scene scene = scene_of("xs 1 1 1 0 0 0 0 0 0 5{tpa 2 "
                                 "1 0 0 0 0 0 2 1 0 0 0 0 1 0 1 0 0 0 1 "
                                 "3 4 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 0 1}");
    EXPECT_EQ(posed(scene, 0).position[0], glm::vec3(0, 0, 5));
    EXPECT_EQ(posed(scene, 1).position[0], glm::vec3(0, 0, 5));
    EXPECT_EQ(posed(scene, 1.5).position[0], glm::vec3(1, 0, 5));
    EXPECT_EQ(posed(scene, 3).position[0], glm::vec3(4, 0, 5));
    EXPECT_EQ(posed(scene, 9).position[0], glm::vec3(4, 0, 5));
    const glm::vec3 n = posed(scene, 2).normal[0];
    EXPECT_NEAR(n.y, std::sqrt(0.5f), 1e-6f) << "half-way between z and y, unit length";
}

TEST(Pose, JumpsBetweenShapesAtTheSameTime)
{
    const Scene scene = scene_of("tpa 2 1 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 "
                                 "1 4 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1");
    EXPECT_EQ(posed(scene, 0.9).position[0].x, 0);
    EXPECT_EQ(posed(scene, 1).position[0].x, 4);
}

TEST(Pose, HandsEachDeformingVertexOutOnce)
{
    const Scene scene = deforming(100'003);
    for (const int threads : {1, 2, 7}) {
        const World world = posed(scene, 0.5, threads);
        for (std::size_t v = 0; v < world.position.size(); ++v)
            ASSERT_EQ(world.position[v], glm::vec3(v, 0.5f, 0));
    }
}

TEST(Pose, MovesDeformingPartsByTheirNode)
{
    Scene scene = deforming(3);
    scene.nodes[0].local = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 9));
    EXPECT_EQ(posed(scene, 2).position[2], glm::vec3(2, 2, 9));
}

TEST(Pose, GivesTheSameBitsForEveryNumberOfThreads)
{
    std::string text;
    for (int k = 0; k < 50; ++k)
        text += "x n" + std::to_string(k) + "{xs 1 2 3 1 " + std::to_string(k) +
                " 1 77 1 2 3 { s 1 2 3 " + std::to_string(k + 1) +
                " } tpa 1 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 } " +
                track_text("n" + std::to_string(k), {k, 0, 0}, {0, k, 1});
    const Scene scene = scene_of(text);
    const World one = posed(scene, 0.3, 1);
    for (const int threads : {2, 3, 7}) {
        const World many = posed(scene, 0.3, threads);
        EXPECT_TRUE(same_bits(one.position, many.position));
        EXPECT_TRUE(same_bits(one.normal, many.normal));
        EXPECT_TRUE(same_bits(one.node_matrix, many.node_matrix));
    }
}

TEST(Pose, MovesLightsByTheirTracks)
{
    const Scene scene =
        scene_of("la lamp 1 1 1 l 2 2 2 " + track_text("lamp", {0, 0, 0}, {4, 0, 0}));
    const World world = posed(scene, 0.5);
    ASSERT_EQ(world.lights.size(), 2u);
    EXPECT_EQ(world.lights[0].position, glm::dvec3(2, 0, 0));
    EXPECT_EQ(world.lights[1].position, glm::dvec3(2, 2, 2));
}

TEST(Pose, MovesSpotsByTheirTracksAndTurnsNoLight)
{
    Scene scene = scene_of("la lamp 1 1 1 " + track_text("lamp", {0, 0, 0}, {4, 0, 0}));
    for (const Light::Kind kind : {Light::Kind::spot, Light::Kind::directional}) {
        Light light = scene.lights[0];
        light.kind = kind;
        light.position = {0, 8, 0};
        light.direction = {1, 2, 3};
        scene.lights.push_back(light);
    }
    const World world = posed(scene, 0.5);
    EXPECT_EQ(world.lights[1].position, glm::dvec3(2, 8, 0));
    EXPECT_EQ(world.lights[2].position, glm::dvec3(2, 8, 0));
    for (const std::size_t light : {1u, 2u})
        EXPECT_EQ(world.lights[light].direction, glm::dvec3(1, 2, 3));
}

TEST(Pose, MovesTheCameraByItsTrack)
{
    const Scene scene =
        scene_of("v from 0 0 9 at 0 0 8 up 0 1 0 angle 90 hither 1 resolution 1 1 " +
                 track_text("camera", {0, 0, 0}, {4, 0, 0}));
    const World world = posed(scene, 1);
    EXPECT_EQ(world.camera.eye, glm::dvec3(4, 0, 0));
    EXPECT_EQ(world.camera.direction, glm::dvec3(0, 0, -1));
}

TEST(Pose, FramesTheWorldWhereThereIsNoCamera)
{
    const World world = posed(scene_of(kTriangle), 0);
    EXPECT_EQ(world.camera.eye, framing_camera(world).eye);
}

TEST(Pose, PosesNothingAtAll)
{
    const World world = posed(scene_of("l 0 0 0"), 0, 2);
    EXPECT_TRUE(world.position.empty());
    EXPECT_EQ(world.lights.size(), 1u);
}

TEST(Pose, ReusesAWorldForAnotherScene)
{
    World world;
    pose(scene_of("x a{s 0 0 0 1} l 0 0 0 l 1 1 1"), 0, world);
    const Scene small = scene_of(kTriangle);
    pose(borrow(small), 0, world);
    EXPECT_EQ(world.position.size(), 3u);
    EXPECT_EQ(world.node_matrix.size(), 1u);
    EXPECT_TRUE(world.lights.empty());
}

TEST(Pose, NamesThePartWithACoordinateThatIsNotFinite)
{
    const Scene scene =
        scene_of(kTriangle + "xs 1e30 1e30 1e30 0 0 0 0 0 0 0{xs 1e30 1 1 0 0 0 0 0 0 0{\n" +
                 kTriangle + "}}");
    EXPECT_EQ(message_of<SceneError>([&] { posed(scene, 0); }),
        "main.aff: instance 1 'main.aff:3' has a coordinate that is not finite at 0.000000 s");
    Scene wave = deforming(10);
    wave.instances[0].deform = [](double, std::size_t first, std::size_t last, glm::vec3* p,
                                   glm::vec3* n) {
        std::fill_n(p, last - first, glm::vec3(std::nanf("")));
        std::fill_n(n, last - first, glm::vec3(0, 0, 1));
    };
    EXPECT_EQ(message_of<SceneError>([&] { posed(wave, 0); }),
        ": instance 0 has a coordinate that is not finite at 0.000000 s");
}

TEST(Pose, RefusesTimesThatAreNotFinite)
{
    const Scene scene = scene_of(kTriangle);
    for (const double t : {std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(message_of<ArgumentError>([&] { posed(scene, t); }),
            "the time of a pose must be a finite number");
}

TEST(Pose, RefusesScenesThatContradictThemselves)
{
    const Scene good = scene_of("x a{" + kTriangle + "}" + kTriangle + "la l 0 0 0 k l{}");
    EXPECT_NO_THROW(posed(good, 0));
    const auto expect = [&](auto change, const std::string& message) {
        Scene bad = good;
        change(bad);
        EXPECT_EQ(message_of<SceneError>([&] { posed(bad, 0); }), "main.aff: " + message);
    };
    expect([](Scene& s) { s.nodes[1].parent = 1; }, "node 1 comes before its parent 1");
    expect([](Scene& s) { s.lights[0].node = 7; }, "node 7 is out of range (2 exist)");
    expect([](Scene& s) { s.cameras.push_back({.node = 2}); }, "node 2 is out of range (2 exist)");
    expect([](Scene& s) { s.clips.emplace_back().channels.emplace_back().node = 9; },
        "node 9 is out of range (2 exist)");
    expect([](Scene& s) { s.instances[0].shape = 0; }, "shape 0 is out of range (0 exist)");
    expect(
        [](Scene& s) {
            s.shapes.resize(1);
            s.shapes[0].targets.emplace_back().position = {{1, 2, 3}};
            s.instances[0].shape = 0;
        },
        "instance 0 'main.aff:1' has morph targets or skin weights without all of its 3 vertices");
    expect([](Scene& s) { s.instances[1].node = 5; }, "node 5 is out of range (2 exist)");
    expect([](Scene& s) { s.instances[1].first_vertex = 4; },
        "instance 1 'main.aff:2' starts at vertex 4 instead of 3: instances must follow each other "
        "without "
        "gaps");
    expect([](Scene& s) { s.normal.pop_back(); },
        "instance 1 'main.aff:2' lacks positions or normals");
    expect([](Scene& s) { s.vertices = 7; }, "the instances have 6 vertices, the scene 7");
    expect([](Scene& s) { s.instances[1].morph.resize(1); },
        "instance 1 'main.aff:2' has a shape without all of its 3 vertices");
}

} // namespace
} // namespace firsthit
