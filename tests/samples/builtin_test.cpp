// builtin_test.cpp - the library's own scenes have the counts and shapes they promise.
#include "samples/builtin.h"
#include "scene/model/check_scene.h"

#include <firsthit/error.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace firsthit {
namespace {

TEST(Torus, Has1024TrianglesAndUnitNormals)
{
    const Scene scene = make_torus();
    EXPECT_EQ(scene.triangle_count(), 1024u);
    EXPECT_EQ(scene.vertices, 512u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
    for (const glm::vec3& n : scene.normal) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(Torus, IsClosedAndWoundOutwards)
{
    const Scene scene = make_torus();
    std::map<std::pair<unsigned, unsigned>, int> edges;
    for (const glm::uvec3& t : scene.index) {
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
        const glm::vec3 a = scene.position[t.x];
        const glm::vec3 face = glm::cross(scene.position[t.y] - a, scene.position[t.z] - a);
        EXPECT_GT(glm::dot(face, scene.normal[t.x]), 0.0f);
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ((edges.count({edge.second, edge.first})), 1u);
    }
}

class Wave : public testing::Test {
  protected:
    /// All vertices at a time, asked for in runs of the given length.
    static std::pair<std::vector<glm::vec3>, std::vector<glm::vec3>> shape(
        const Scene& scene, double time_s, std::size_t run)
    {
        std::vector<glm::vec3> position(scene.vertices);
        std::vector<glm::vec3> normal(scene.vertices);
        for (std::size_t first = 0; first < scene.vertices; first += run)
            scene.instances[0].deform(time_s, first, std::min(scene.vertices, first + run),
                &position[first], &normal[first]);
        return {position, normal};
    }
};

TEST_F(Wave, HasAboutAsManyTrianglesAsAsked)
{
    EXPECT_EQ(make_wave(2).triangle_count(), 2u);
    EXPECT_EQ(make_wave(10'000).triangle_count(), 10'080u);
    for (const std::uint64_t n : {3u, 7u, 100u, 12'345u, 1'000'000u}) {
        const std::size_t triangles = make_wave(n).triangle_count();
        EXPECT_GE(triangles, n);
        EXPECT_LE(static_cast<double>(triangles),
            static_cast<double>(n) + 2 * std::sqrt(static_cast<double>(n)) + 2);
    }
}

TEST_F(Wave, RefusesSizesOutOfRange)
{
    EXPECT_THROW(make_wave(1), ArgumentError);
    EXPECT_THROW(make_wave(10'000'001), ArgumentError);
}

TEST_F(Wave, KeepsNoVerticesInTheScene)
{
    const Scene scene = make_wave(1'000'000);
    EXPECT_TRUE(scene.position.empty());
    EXPECT_TRUE(scene.normal.empty());
    EXPECT_EQ(scene.owner.size(), scene.index.size());
    EXPECT_NO_THROW(check_scene(scene));
}

TEST_F(Wave, IsTheSameInWhateverRangesItIsAskedFor)
{
    const Scene scene = make_wave(20'000);
    const auto whole = shape(scene, 1.25, scene.vertices);
    for (const std::size_t run : {1u, 63u, 64u, 101u, 4096u})
        EXPECT_EQ(shape(scene, 1.25, run), whole) << run;
}

TEST_F(Wave, HasTheNormalsOfItsTriangles)
{
    const Scene scene = make_wave(200'000);
    const auto [position, normal] = shape(scene, 3.7, scene.vertices);
    for (const glm::uvec3& t : scene.index) {
        const glm::vec3 face = glm::normalize(
            glm::cross(position[t.y] - position[t.x], position[t.z] - position[t.x]));
        ASSERT_GT(glm::dot(face, normal[t.x]), 0.995f);
        ASSERT_NEAR(glm::length(normal[t.x]), 1.0f, 1e-5f);
    }
}

TEST_F(Wave, MovesEveryVertexAndRepeatsAfterTenSeconds)
{
    const Scene scene = make_wave(5'000);
    const auto [a, na] = shape(scene, 0.5, scene.vertices);
    const auto [b, nb] = shape(scene, 0.5 + 1.0 / 30, scene.vertices);
    const auto [c, nc] = shape(scene, 10.5, scene.vertices);
    for (std::size_t v = 0; v < scene.vertices; ++v) {
        EXPECT_NE(na[v], nb[v]);
        EXPECT_LT(glm::length(a[v] - c[v]), 1e-5f);
    }
}

TEST(BuiltinRobots, HaveTheCountsTheyPromise)
{
    const Scene scene = make_robots();
    EXPECT_GE(scene.triangle_count(), 70'000u);
    EXPECT_LE(scene.triangle_count(), 75'000u);
    EXPECT_EQ(scene.begin_s(), 0.0);
    EXPECT_EQ(scene.end_s(), 10.0);
    EXPECT_GE(scene.cameras.at(0).node, 0);
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(BuiltinRobots, AreTheSameEveryTime)
{
    const Scene a = make_robots();
    const Scene b = make_robots();
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.index, b.index);
    const std::vector<Channel>&channels = a.clips.at(0).channels, &others = b.clips.at(0).channels;
    ASSERT_EQ(channels.size(), others.size());
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t k = 0; k < channels[c].tcb.size(); ++k)
            EXPECT_EQ(channels[c].tcb[k].value, others[c].tcb[k].value);
    EXPECT_TRUE(std::ranges::equal(a.textures[0].texels(), b.textures[0].texels()));
}

TEST(BuiltinRobots, HaveTracksThatCoverTheWholeTime)
{
    const Scene scene = make_robots();
    for (const Channel& channel : scene.clips.at(0).channels) {
        const std::vector<TcbKey>& keys = channel.tcb;
        const std::string& name = scene.nodes[channel.node].name;
        ASSERT_GE(keys.size(), 4u) << name;
        for (std::size_t k = 1; k < keys.size(); ++k) EXPECT_LT(keys[k - 1].time_s, keys[k].time_s);
        // The first and last keys only shape tangents; constant properties may be shorter.
        const bool constant = keys.front().value == keys.back().value;
        if (constant) continue;
        EXPECT_LE(keys[1].time_s, scene.begin_s() + 1e-9) << name;
        EXPECT_GE(keys[keys.size() - 2].time_s, scene.end_s() - 1e-9) << name;
    }
}

TEST(BuiltinRobots, AreTriangledWithoutHolesInTheWinding)
{
    // Every triangle faces the way of its normals.
    const Scene scene = make_robots();
    std::size_t opposed = 0;
    for (const glm::uvec3& t : scene.index) {
        const glm::vec3 a = scene.position[t.x];
        const glm::vec3 face = glm::cross(scene.position[t.y] - a, scene.position[t.z] - a);
        const glm::vec3 sum = scene.normal[t.x] + scene.normal[t.y] + scene.normal[t.z];
        EXPECT_GT(glm::length(face), 0.0f);
        if (glm::dot(face, sum) <= 0) ++opposed;
    }
    EXPECT_EQ(opposed, 0u);
}

TEST(BuiltinRobots, TextureHasAllItsLevels)
{
    const Scene scene = make_robots();
    ASSERT_FALSE(scene.textures.empty());
    const Texture& texture = scene.textures[0];
    EXPECT_EQ(texture.width(texture.levels() - 2), 2);
    EXPECT_EQ(texture.width(texture.levels() - 1), 1);
    EXPECT_EQ(texture.height(texture.levels() - 1), 1);
}

} // namespace
} // namespace firsthit
