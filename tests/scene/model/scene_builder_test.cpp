// scene_builder_test.cpp - scenes that are put together from their pieces.
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/scene_builder.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

namespace firsthit {
namespace {

Material material(const char* name)
{
    Material made;
    made.name = name;
    return made;
}

/// A square of two triangles in the plane z = 0.
Mesh square()
{
    Mesh mesh;
    mesh.shape.name = "square";
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normal.assign(4, {0, 0, 1});
    mesh.index = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Scene two_squares()
{
    SceneBuilder builder("two");
    const std::uint32_t mesh = builder.add_mesh(square());
    const std::uint32_t grey = builder.add_material(material("grey"));
    const std::uint32_t red = builder.add_material(material("red"));
    Node moved{.name = "moved"};
    moved.local = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 5));
    builder.add_instance(mesh, builder.add_node({.name = "still"}), grey);
    builder.add_instance(mesh, builder.add_node(moved), red, -1, "second");
    return builder.build();
}

TEST(SceneBuilder, PlacesAMeshAsOftenAsItHasInstances)
{
    const Scene scene = two_squares();
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].name, "still") << "the node's, where it has none";
    EXPECT_EQ(scene.instances[1].name, "second");
    EXPECT_EQ(scene.instances[1].material, 1u);
    EXPECT_EQ(scene.instances[1].first_vertex, 4u);
    EXPECT_EQ(scene.instances[1].first_triangle, 2u);
    EXPECT_EQ(scene.index[2], glm::uvec3(4, 5, 6));
    EXPECT_EQ(scene.owner, (std::vector<std::uint32_t>{0, 0, 1, 1}));
    World world;
    pose(std::make_shared<const Scene>(scene), 0, world);
    EXPECT_EQ(world.position[6], glm::vec3(1, 1, 5));
}

TEST(SceneBuilder, FillsWhatOnlySomeMeshesHave)
{
    SceneBuilder builder("some");
    Mesh with = square();
    with.uv.assign(4, {0.5f, 0.25f});
    with.color.assign(4, {1, 0, 0, 0.5f});
    const std::uint32_t node = builder.add_node({.name = "node"});
    const std::uint32_t grey = builder.add_material(material("grey"));
    builder.add_instance(builder.add_mesh(square()), node, grey);
    builder.add_instance(builder.add_mesh(std::move(with)), node, grey);
    builder.add_instance(builder.add_mesh(square()), node, grey);
    const Scene scene = builder.build();
    ASSERT_EQ(scene.uv.size(), 12u);
    EXPECT_EQ(scene.uv[0], glm::vec2(0));
    EXPECT_EQ(scene.uv[4], glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(scene.uv[8], glm::vec2(0));
    EXPECT_EQ(scene.color[3], glm::vec4(1));
    EXPECT_EQ(scene.color[7], glm::vec4(1, 0, 0, 0.5f));
    EXPECT_TRUE(scene.tangent.empty());
}

TEST(SceneBuilder, MakesTrianglesWithoutNormalsFlat)
{
    SceneBuilder builder("flat");
    Mesh mesh = square();
    mesh.normal.clear();
    mesh.position[3] = {0, 1, 1};
    builder.add_instance(builder.add_mesh(mesh), builder.add_node({.name = "node"}),
        builder.add_material(material("grey")));
    const Scene scene = builder.build();
    ASSERT_EQ(scene.vertices, 6u);
    EXPECT_FALSE(scene.instances[0].facet_normals) << "it does not change its shape";
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
    const glm::vec3 second = glm::normalize(glm::vec3(1, -1, 1));
    EXPECT_LT(glm::length(scene.normal[4] - second), 1e-6f);
}

TEST(SceneBuilder, MakesNormalsOfFlatTrianglesAnewInEveryPose)
{
    SceneBuilder builder("flat");
    Mesh mesh = square();
    mesh.normal.clear();
    mesh.shape.targets.push_back({"lift", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}}, {}, {}});
    builder.add_instance(builder.add_mesh(mesh), builder.add_node({.name = "node"}),
        builder.add_material(material("grey")));
    Channel lift;
    lift.path = Channel::Path::weights;
    lift.time_s = {0, 1};
    lift.value = {0, 1};
    builder.add_channel(lift);
    const auto scene = std::make_shared<const Scene>(builder.build());
    ASSERT_TRUE(scene->instances[0].facet_normals);
    World world;
    pose(scene, 0, world);
    EXPECT_EQ(world.normal[4], glm::vec3(0, 0, 1));
    pose(scene, 1, world);
    EXPECT_LT(glm::length(world.normal[4] - glm::normalize(glm::vec3(1, -1, 1))), 1e-6f);
    EXPECT_EQ(world.normal[0], glm::vec3(0, 0, 1));
}

TEST(SceneBuilder, HasWeightsOfTheClipElseOfTheNodeElseOfTheMesh)
{
    for (const bool node_has : {false, true})
        for (const bool clip_has : {false, true}) {
            SceneBuilder builder("weights");
            Mesh mesh = square();
            mesh.shape.targets.push_back(
                {"up", {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, {}});
            mesh.shape.weights = {2};
            Node node{.name = "node"};
            if (node_has) node.weights = {3};
            builder.add_instance(builder.add_mesh(mesh), builder.add_node(node),
                builder.add_material(material("grey")));
            Channel up;
            up.path = Channel::Path::weights;
            up.time_s = {0};
            up.value = {4};
            if (clip_has) builder.add_channel(up);
            World world;
            const auto scene = std::make_shared<const Scene>(builder.build());
            pose(scene, 0, world);
            EXPECT_EQ(world.position[0].z, clip_has ? 4 : node_has ? 3 : 2);
            pose(scene, PoseSettings{.clip = PoseSettings::kRest}, world);
            EXPECT_EQ(world.position[0].z, node_has ? 3 : 2);
        }
}

TEST(SceneBuilder, PlacesLightsAndCamerasByTheirNodes)
{
    SceneBuilder builder("lit");
    Node node{.name = "arm"};
    node.transform = NodeTransform{.translation = {1, 2, 3},
        .rotation = glm::angleAxis(3.14159265358979323846 / 2, glm::dvec3(0, 1, 0))};
    const auto arm = std::int32_t(builder.add_node(node));
    builder.add_light({.kind = Light::Kind::spot, .direction = {0, 0, -1}, .node = arm});
    builder.add_camera({.name = "first"});
    builder.add_camera({.name = "second", .camera = {.eye = {0, 0, 1}}, .node = arm});
    const auto scene = std::make_shared<const Scene>(builder.build());
    World world;
    pose(scene, PoseSettings{.camera = 1}, world);
    EXPECT_EQ(world.lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_LT(glm::length(world.lights[0].direction - glm::dvec3(-1, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(world.camera.eye - glm::dvec3(2, 2, 3)), 1e-12);
    EXPECT_LT(glm::length(world.camera.direction - glm::dvec3(-1, 0, 0)), 1e-12);
    pose(scene, 0, world);
    EXPECT_EQ(world.camera.eye, Camera{}.eye);
    EXPECT_EQ(message_of<ArgumentError>([&] { pose(scene, PoseSettings{.camera = 2}, world); }),
        "lit: there is no camera 2 (2 exist)");
    EXPECT_EQ(message_of<ArgumentError>([&] { pose(scene, PoseSettings{.clip = 1}, world); }),
        "lit: there is no clip 1 (0 exist)");
}

TEST(SceneBuilder, NamesTheMeshThatDoesNotFit)
{
    const auto message = [](const std::function<void(Mesh&)>& change) {
        return message_of<SceneError>([&] {
            SceneBuilder builder("bad");
            Mesh mesh = square();
            change(mesh);
            builder.add_instance(builder.add_mesh(std::move(mesh)), builder.add_node({.name = "n"}),
                builder.add_material(material("grey")));
            builder.build();
        });
    };
    const std::string what = "bad: mesh 0 'square': ";
    EXPECT_EQ(message([](Mesh& m) { m.normal.pop_back(); }), what + "3 normals for 4 vertices");
    EXPECT_EQ(
        message([](Mesh& m) { m.uv.resize(9); }), what + "9 texture coordinates for 4 vertices");
    EXPECT_EQ(message([](Mesh& m) { m.index[1].y = 4; }),
        what + "triangle 1: vertex 4 is out of range (4 vertices)");
    EXPECT_EQ(message([](Mesh& m) { m.shape.skin.influences = 2; }),
        what + "0 joints and 0 weights for 4 vertices with 2 influences");
    EXPECT_EQ(message([](Mesh& m) {
        m.shape.targets.push_back({"t", {{1, 2, 3}}, {}, {}});
    }),
        what + "1 displacements of a morph target for 4 vertices");
    EXPECT_EQ(message_of<SceneError>([] {
        SceneBuilder builder("bad");
        builder.add_instance(0, 0, 0);
        builder.build();
    }),
        "bad: an instance's mesh 0 is out of range (0)");
}

} // namespace
} // namespace firsthit
