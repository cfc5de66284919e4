// robots_reference_test.cpp - BART's robots against values of an independent implementation.
#include "readers/aff/aff.h"
#include "scene/animate/evaluate_channel.h"
#include "scene/animate/tcb_spline.h"
#include "scene/animate/track.h"
#include "io/whole_file.h"

#include "scene/model/borrow.h"
#include "test_data.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace firsthit {
namespace {

constexpr double kTolerance = 1e-4;

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], kTolerance);
}

class Robots : public testing::Test {
  protected:
    static void SetUpTestSuite()
    {
        const auto path = test_data("bart/scene_robot/aff/Robot.aff");
        if (!path) return;
        scene_ = new Scene(parse_aff(
            path->string(), read_whole_file(*path), aff_files_beside(*path), {}, &meshes_));
    }
    static void TearDownTestSuite()
    {
        delete scene_;
        scene_ = nullptr;
    }
    void SetUp() override
    {
        if (!scene_) GTEST_SKIP() << "FIRSTHIT_TEST_DATA has no bart/scene_robot/aff/Robot.aff";
    }

    /// What moves the node of this name.
    static Track track(const std::string& name)
    {
        const auto node = std::find_if(scene_->nodes.begin(), scene_->nodes.end(),
            [&](const Node& n) { return n.name == name && n.transform; });
        EXPECT_NE(node, scene_->nodes.end()) << name;
        Track track;
        for (const Channel& channel : scene_->clips.at(0).channels) {
            if (channel.node != std::uint32_t(node - scene_->nodes.begin())) continue;
            if (channel.path == Channel::Path::translation) track.translation = channel.tcb;
            if (channel.path == Channel::Path::rotation) track.rotation = channel.tcb;
            if (channel.path == Channel::Path::scale) track.scale = channel.tcb;
        }
        return track;
    }
    static World posed(double time_s)
    {
        World world;
        pose(borrow(*scene_), time_s, world);
        return world;
    }
    static glm::dvec3 mesh_vertex_mean(double time_s)
    {
        const World world = posed(time_s);
        glm::dvec3 sum(0);
        std::size_t count = 0;
        for (const AffMeshRange& range : meshes_)
            for (std::uint32_t k = 0; k < range.count; ++k, ++count)
                sum += glm::dvec3(world.position[range.first + k]);
        return sum / double(count);
    }
    /// The rows of a track's rotation.
    static void expect_rotation(const Track& t, double time_s, const glm::dmat3& rows)
    {
        const glm::dmat4 m = matrix_of(transform_at(t, time_s));
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(m[c][r], rows[r][c], kTolerance);
    }

    static inline Scene* scene_ = nullptr;
    static inline std::vector<AffMeshRange> meshes_;
};

TEST_F(Robots, HaveExactlyTheTrianglesOfThePaper)
{
    EXPECT_EQ(scene_->triangle_count(), 71'708u);
    EXPECT_EQ(scene_->owner.size(), 71'708u);
}

TEST_F(Robots, HaveAllMeshVerticesInFileOrder)
{
    std::size_t count = 0;
    for (const AffMeshRange& range : meshes_) count += range.count;
    EXPECT_EQ(meshes_.size(), 1849u);
    EXPECT_EQ(count, 134'127u);
}

TEST_F(Robots, AreTenOfEqualSizeInAStaticCity)
{
    // Each robot hangs below a node that some track moves; the city below none.
    std::vector<std::int32_t> top(scene_->nodes.size(), -1);
    for (std::size_t n = 1; n < top.size(); ++n) {
        const std::int32_t parent = scene_->nodes[n].parent; // -1 for the camera's node
        const std::int32_t above = parent < 0 ? -1 : top[static_cast<std::size_t>(parent)];
        top[n] = above >= 0                   ? above
                 : scene_->nodes[n].transform ? static_cast<std::int32_t>(n)
                                              : -1;
    }
    std::map<std::int32_t, std::size_t> triangles;
    for (const Instance& instance : scene_->instances)
        triangles[top[instance.node]] += instance.triangle_count;
    EXPECT_EQ(triangles.size(), 11u);
    for (const auto& [node, count] : triangles) EXPECT_EQ(count, node < 0 ? 9218u : 6249u);
}

TEST_F(Robots, HaveTheirTracksNodesLightAndTextures)
{
    EXPECT_EQ(std::count_if(scene_->nodes.begin(), scene_->nodes.end(),
                  [](const Node& n) { return n.transform && n.name != "camera"; }),
        185)
        << "of 187 tracks; one is the camera's, one moves nothing";
    EXPECT_EQ(std::count_if(scene_->nodes.begin(), scene_->nodes.end(),
                  [](const Node& n) {
                      return !n.name.empty() && n.name != "world" && n.name != "camera";
                  }),
        190);
    ASSERT_EQ(scene_->lights.size(), 1u);
    EXPECT_EQ(scene_->lights[0].position, glm::dvec3(1, 500, 1));
    EXPECT_EQ(scene_->textures.size(), 44u);
    EXPECT_TRUE(scene_->warnings.empty());
    EXPECT_EQ(scene_->begin_s(), 0);
    EXPECT_EQ(scene_->end_s(), 50);
    EXPECT_EQ(scene_->frames(), 800);
}

TEST_F(Robots, ShareFewParts)
{
    EXPECT_LE(scene_->instances.size(), 1849u);
}

TEST_F(Robots, HaveTheCameraOfTheReferenceAtTenSeconds)
{
    const Camera camera = posed(10).camera;
    expect_near(camera.eye, {4.87908, 17.17828, -162.15806});
    expect_near(camera.direction, {-0.5153, -0.25685, -0.81762});
    expect_near(camera.up, {-0.08615, 0.96472, -0.24877});
    EXPECT_NEAR(camera.fov_y_rad, 0.643501, 1e-6);
}

TEST_F(Robots, HaveTheCameraOfTheReferenceAtThirtySeconds)
{
    const Camera camera = posed(30).camera;
    expect_near(camera.eye, {0, 6, 74});
    expect_near(camera.direction, {0.05234, 0, 0.99863});
    expect_near(camera.up, {0, 1, 0});
}

TEST_F(Robots, MoveByTheTranslationOfTheReference)
{
    expect_near(transform_at(track("robot_transl1"), 10).translation, {-7.21438, 0, -186.04316});
}

TEST_F(Robots, TurnByTheRotationsOfTheReference)
{
    expect_rotation(
        track("robot_rot1"), 10, {-0.99914, 0, 0.04145, 0, 1, 0, -0.04145, 0, -0.99914});
    expect_rotation(track("lo_leg_rot1"), 10, {1, 0, 0, 0, 0.90809, 0.41877, 0, -0.41877, 0.90809});
}

TEST_F(Robots, HaveTheVertexMeanOfTheReference)
{
    expect_near(mesh_vertex_mean(0), {-7.7951, 10.6956, -46.8787});
    expect_near(mesh_vertex_mean(10), {-7.5617, 10.8143, -37.7303});
}

TEST_F(Robots, HaveUnitNormals)
{
    const World world = posed(10);
    for (const glm::vec3& n : world.normal) ASSERT_NEAR(glm::dot(n, n), 1.0f, 1e-5f);
}

TEST_F(Robots, WindTheirTrianglesAsTheirNormalsSay)
{
    // Counted in the data: 10 oppose, 128 have no area.
    std::size_t agree = 0;
    for (const glm::uvec3& t : scene_->index) {
        const glm::dvec3 a(scene_->position[t.x]), b(scene_->position[t.y]),
            c(scene_->position[t.z]);
        const glm::vec3 n = scene_->normal[t.x] + scene_->normal[t.y] + scene_->normal[t.z];
        agree += glm::dot(glm::cross(b - a, c - a), glm::dvec3(n)) > 0;
    }
    EXPECT_GE(agree, 71'470u);
}

} // namespace
} // namespace firsthit
