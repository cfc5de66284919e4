// scene_buffers_test.cpp - posing vertices on OpenGL, and uploading only what has changed.
#include "gl/scene/scene_buffers.h"

#include "gl_context.h"
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"
#include "visibility/bin/project.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

using SceneBuffers = test::OnContext;

Pencil pencil_at(const World& world)
{
    View view{world.camera, 256, 256, {0, 0, 256, 256}};
    return pencil_of(view, view.region, 1);
}

std::vector<glm::vec4> content(const gl::Buffer& buffer, std::size_t count)
{
    std::vector<glm::vec4> values(count);
    glGetNamedBufferSubData(buffer.name(), 0, GLsizeiptr(count * sizeof(glm::vec4)), values.data());
    return values;
}

struct CpuEyeSpace {
    EyeMesh mesh;
    CpuEyeSpace(const World& world, const Pencil& pencil)
    {
        Tasks tasks(1);
        project_vertices(world.position, pencil, mesh, tasks);
    }
    std::vector<glm::vec4> corners(std::size_t count) const
    {
        return {mesh.corner.data(), mesh.corner.data() + count};
    }
};

/// Expects the same bits as on the CPU for eye space and world positions, and nearly equal normals.
void expect_posed(const gl::SceneBuffers& buffers, const World& world, const Pencil& pencil)
{
    const std::size_t count = world.position.size();
    const auto eye = CpuEyeSpace(world, pencil).corners(count);
    const auto posed = content(buffers.eye(), count);
    const auto position = content(buffers.world(), count);
    const auto normal = content(buffers.normal(), count);
    std::size_t other_eye = 0, other_world = 0;
    float normal_error = 0;
    for (std::size_t v = 0; v < count; ++v) {
        other_eye += glm::vec3(posed[v]) != glm::vec3(eye[v]);
        other_world += glm::vec3(position[v]) != world.position[v];
        normal_error = std::max(normal_error, glm::length(glm::vec3(normal[v]) - world.normal[v]));
    }
    EXPECT_EQ(other_eye, 0u) << "of " << count;
    EXPECT_EQ(other_world, 0u) << "of " << count;
    EXPECT_LT(normal_error, 1e-5);
}

TEST_F(SceneBuffers, PosesRigidPartsAsTheCpuDoes)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    buffers.pose(world, pencil_at(world));
    expect_posed(buffers, world, pencil_at(world));
}

TEST_F(SceneBuffers, PosesPartsThatDeform)
{
    const Scene scene = load_scene("builtin:wave?n=2000");
    World world;
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    for (const double time : {0.0, 0.3, 0.6, 0.9}) { // around the ring
        pose(borrow(scene), time, world);
        buffers.pose(world, pencil_at(world));
        expect_posed(buffers, world, pencil_at(world));
    }
}

/// A rigid instance between one that morphs and one that deforms, on a node that turns them.
Scene mixed_scene()
{
    Scene scene;
    Node node;
    node.local[3] = {0.3, -0.2, -4, 1};
    scene.nodes = {node};
    scene.materials = {Material{}};
    for (std::uint32_t p = 0; p < 3; ++p) {
        const std::uint32_t first = 3 * p;
        Instance instance;
        instance.first_vertex = first;
        instance.vertex_count = 3;
        instance.first_triangle = p;
        instance.triangle_count = 1;
        for (const glm::vec3 corner : {glm::vec3(-1, -1, 0), {1, -1, 0}, {0, 1, float(p)}})
            scene.position.push_back(corner);
        scene.index.push_back({first, first + 1, first + 2});
        scene.owner.push_back(p);
        scene.instances.push_back(instance);
    }
    scene.vertices = 9;
    scene.normal.assign(9, glm::vec3(0, 0.6f, 0.8f));
    const std::vector<glm::vec3> flat(3, glm::vec3(0, 0, 1));
    scene.instances[0].morph = {
        {0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, flat}, {1, {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}}, flat}};
    scene.instances[2].deform = [](double time_s, std::size_t first, std::size_t last,
                                    glm::vec3* position, glm::vec3* normal) {
        for (std::size_t v = first; v < last; ++v) {
            position[v - first] = {float(v), float(v * v), float(time_s)};
            normal[v - first] = {1, 0, 0};
        }
    };
    return scene;
}

TEST_F(SceneBuffers, PosesRigidPartsAmongOnesThatMorphAndDeform)
{
    const Scene scene = mixed_scene();
    World world;
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    for (const double time : {0.25, 0.5, 0.75}) {
        pose(borrow(scene), time, world);
        const std::uint64_t before = buffers.uploaded_bytes();
        buffers.pose(world, pencil_at(world));
        expect_posed(buffers, world, pencil_at(world));
        // Later frames upload positions and normals of the six moving vertices.
        if (time > 0.25) {
            EXPECT_EQ(buffers.uploaded_bytes() - before, 6 * 2 * sizeof(glm::vec3));
        }
    }
}

TEST_F(SceneBuffers, PoseAgainForAnotherEyeWithoutAnUpload)
{
    const Scene scene = load_scene("builtin:wave?n=2000");
    World world;
    pose(borrow(scene), 0.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    buffers.pose(world, pencil_at(world));
    const std::uint64_t bytes = buffers.uploaded_bytes();
    world.camera.eye.x += 1.0 / 3;
    buffers.pose(world, pencil_at(world));
    EXPECT_EQ(buffers.uploaded_bytes(), bytes);
    expect_posed(buffers, world, pencil_at(world));
}

TEST_F(SceneBuffers, LentEyeSpaceHasTheSameBits)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::items);
    const CpuEyeSpace lent(world, pencil_at(world));
    buffers.lend_eye_space(world, pencil_at(world), lent.mesh.corner.span());
    const std::size_t count = world.position.size();
    EXPECT_EQ(content(buffers.eye(), count), lent.corners(count));
    // Posing again replaces it.
    const std::uint64_t before = buffers.poses();
    buffers.pose(world, pencil_at(world));
    EXPECT_EQ(buffers.poses(), before + 1);
}

TEST_F(SceneBuffers, LentEyeSpaceIsUploadedOnlyWhereItIsNew)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    const CpuEyeSpace lent(world, pencil_at(world));
    const auto lend = [&] {
        const std::uint64_t before = buffers.uploaded_bytes();
        buffers.lend_eye_space(world, pencil_at(world), lent.mesh.corner.span());
        return buffers.uploaded_bytes() - before;
    };
    const std::size_t count = world.position.size();
    EXPECT_GT(lend(), count * sizeof(glm::vec4));
    EXPECT_EQ(lend(), 0u);
    buffers.pose(world, pencil_at(world)); // replaces the lent eye space
    EXPECT_EQ(lend(), count * sizeof(glm::vec4));
    EXPECT_EQ(content(buffers.eye(), count), lent.corners(count));
}

TEST_F(SceneBuffers, UploadNothingForASceneThatIsStill)
{
    const Scene scene = load_scene("builtin:wave?n=2000");
    World world;
    pose(borrow(scene), 0.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    buffers.pose(world, pencil_at(world));
    const std::uint64_t bytes = buffers.uploaded_bytes(), poses = buffers.poses();
    pose(borrow(scene), 0.5, world);
    buffers.pose(world, pencil_at(world));
    EXPECT_EQ(buffers.uploaded_bytes(), bytes);
    EXPECT_EQ(buffers.poses(), poses);
}

TEST_F(SceneBuffers, UploadMatricesAloneForRigidParts)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    buffers.pose(world, pencil_at(world));
    const std::uint64_t bytes = buffers.uploaded_bytes();
    pose(borrow(scene), 2.6, world);
    buffers.pose(world, pencil_at(world));
    EXPECT_GT(buffers.uploaded_bytes(), bytes);
    EXPECT_LE(buffers.uploaded_bytes() - bytes, scene.nodes.size() * sizeof(gl::MatrixData));
}

TEST_F(SceneBuffers, UploadVerticesOfPartsThatDeform)
{
    const Scene scene = load_scene("builtin:wave?n=2000");
    World world;
    pose(borrow(scene), 0.5, world);
    const Pencil still = pencil_at(world);
    gl::SceneBuffers buffers(*context, gl::Detail::items);
    buffers.pose(world, still);
    const std::uint64_t bytes = buffers.uploaded_bytes();
    pose(borrow(scene), 0.6, world);
    buffers.pose(world, still);
    EXPECT_EQ(buffers.uploaded_bytes() - bytes, scene.vertices * sizeof(glm::vec3));
}

TEST_F(SceneBuffers, SeeASceneThatReplacesAnotherAtTheSamePlace)
{
    test::TestWorld one;
    one.add({-1, -1, 4}, {1, -1, 4}, {0, 1, 4});
    const World& world = one.finish();
    gl::SceneBuffers buffers(*context, gl::Detail::items);
    buffers.pose(world, pencil_at(world));
    one.scene->position[0] = {-2, -1, 4};
    buffers.pose(world, pencil_at(world));
    const glm::dvec3 expected =
        pencil_at(world).eye_from_world * (glm::dvec3(-2, -1, 4) - world.camera.eye);
    EXPECT_LT(glm::length(glm::dvec3(content(buffers.eye(), 1)[0]) - expected), 1e-3);
}

TEST_F(SceneBuffers, CollapsePartsThatAreNotVisible)
{
    test::TestWorld hidden;
    hidden.add({-1, -1, 4}, {1, -1, 4}, {0, 1, 4});
    hidden.finish();
    hidden.world.node_visible = {0};
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    buffers.pose(hidden.world, pencil_at(hidden.world));
    const auto eye = content(buffers.eye(), 3);
    EXPECT_EQ(eye[0], eye[1]);
    EXPECT_EQ(eye[1], eye[2]);
    EXPECT_EQ(content(buffers.normal(), 1)[0], glm::vec4(0, 0, 1, 0));
}

TEST_F(SceneBuffers, AcceptAnEmptyScene)
{
    test::TestWorld empty;
    empty.finish();
    gl::SceneBuffers buffers(*context, gl::Detail::surfaces);
    EXPECT_NO_THROW(buffers.pose(empty.world, pencil_at(empty.world)));
    EXPECT_EQ(buffers.triangles(), 0u);
}

TEST_F(SceneBuffers, TooManyVerticesAreAnErrorWithNumbers)
{
    Scene scene;
    scene.name = "vast";
    scene.vertices = std::size_t(context->info().max_storage_bytes) / 16 + 1;
    World world;
    world.scene = borrow(scene);
    gl::SceneBuffers buffers(*context, gl::Detail::items);
    const std::string message = message_of<DeviceError>([&] { buffers.pose(world, Pencil{}); });
    EXPECT_NE(
        message.find("vast: " + std::to_string(scene.vertices) + " vertices"), std::string::npos)
        << message;
    EXPECT_NE(message.find(std::to_string(context->info().max_storage_bytes)), std::string::npos)
        << message;
}

} // namespace
} // namespace firsthit
