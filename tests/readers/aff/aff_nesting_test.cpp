// aff_nesting_test.cpp - transforms inside transforms and files inside files.
#include "readers/aff/aff_text.h"
#include "scene/model/borrow.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace firsthit {
namespace {

void expect_point(const glm::dmat4& m, const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec4 moved = m * glm::dvec4(from, 1);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(moved[axis], to[axis], 1e-12);
}

TEST(AffNesting, ScalesThenTurnsThenMoves)
{
    // (1, 0, 0) -> scaled (2, 0, 0) -> a quarter turn about z (0, 2, 0) -> moved (10, 22, 30).
    const Scene scene = scene_of("xs 2 3 4 0 0 1 90 10 20 30 {" + kTriangle + "}");
    ASSERT_EQ(scene.nodes.size(), 2u);
    expect_point(scene.nodes[1].local, {1, 0, 0}, {10, 22, 30});
}

TEST(AffNesting, NormalisesTheAxis)
{
    const Scene scene = scene_of("xs 1 1 1 0 0 5 90 0 0 0 {" + kTriangle + "}");
    expect_point(scene.nodes[1].local, {1, 0, 0}, {0, 1, 0});
}

TEST(AffNesting, PutsParentsBeforeChildren)
{
    const Scene scene = scene_of("x a{x b{" + kTriangle + "}x c{" + kTriangle + "}}" + kTriangle);
    ASSERT_EQ(scene.nodes.size(), 4u);
    EXPECT_EQ(scene.nodes[0].parent, -1);
    EXPECT_EQ(scene.nodes[2].name, "b");
    EXPECT_EQ(scene.nodes[2].parent, 1);
    EXPECT_EQ(scene.nodes[3].parent, 1);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances[0].node, 2u);
    EXPECT_EQ(scene.instances[1].node, 3u);
    EXPECT_EQ(scene.instances[2].node, 0u);
}

TEST(AffNesting, BindsNodesToTracksThatComeLaterOrNever)
{
    const Scene scene = scene_of("x a{i 0 sub.aff}", {{"sub.aff", "x b{} x c{} k c{} k a{}"}});
    EXPECT_TRUE(scene.nodes[1].transform) << "a, which the last file has";
    EXPECT_FALSE(scene.nodes[2].transform) << "b, which no file has";
    EXPECT_TRUE(scene.nodes[3].transform) << "c";
}

TEST(AffNesting, LetsTheLastTrackOfAnameCount)
{
    const Scene scene = scene_of("k a{visibility 1 0 0} x a{} k a{visibility 2 1 0 2 1}");
    ASSERT_EQ(scene.clips.at(0).channels.size(), 1u);
    EXPECT_EQ(scene.clips[0].channels[0].time_s.size(), 3u) << "and visible before the first";
}

TEST(AffNesting, IncludesInTheMiddleOfANode)
{
    const Scene scene = scene_of("x a{i 0 sub.aff}" + kTriangle, {{"sub.aff", kTriangle}});
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].node, 1u);
    EXPECT_EQ(scene.instances[0].name, "sub.aff:1");
    EXPECT_EQ(scene.instances[1].node, 0u);
}

TEST(AffNesting, KeepsAnIncludedMaterial)
{
    const Scene scene = scene_of(
        "f 1 0 0 1 0 1 0 1 x a {i 0 c.aff} " + kTriangle, {{"c.aff", "f 0 1 0 1 0 1 0 1"}});
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).diffuse, glm::vec3(0, 1, 0));
}

TEST(AffNesting, IncludesUpToTheDetailLevel)
{
    const std::map<std::string, std::string> files = {{"t.aff", kTriangle}};
    EXPECT_EQ(scene_of("i 0 t.aff i 1 t.aff", files).triangle_count(), 1u);
    EXPECT_EQ(scene_of("d 2 i 1 t.aff i 2 t.aff i 3 gone.aff", files).triangle_count(), 2u);
    EXPECT_EQ(scene_of("i 1 t.aff d 1 i 1 t.aff", files).triangle_count(), 1u);
}

TEST(AffNesting, IncludesAFileAsOftenAsItIsNamed)
{
    std::string text;
    for (int k = 0; k < 1000; ++k) text += "i 0 t.aff\n";
    EXPECT_EQ(scene_of(text, {{"t.aff", kTriangle}}).triangle_count(), 1000u);
}

TEST(AffNesting, ReadsTransformsTenThousandDeep)
{
    const int depth = 10'000;
    std::string text;
    for (int k = 0; k < depth; ++k) text += k % 2 ? "x n{" : "xs 1 1 1 0 0 0 0 0 0 1{";
    text += kTriangle + std::string(depth, '}');
    const Scene scene = scene_of(text);
    EXPECT_EQ(scene.nodes.size(), std::size_t(depth + 1));
    World world;
    pose(borrow(scene), 0, world);
    EXPECT_EQ(world.position[0], glm::vec3(0, 0, depth / 2));
}

TEST(AffNesting, ReadsIncludesTenThousandDeep)
{
    std::map<std::string, std::string> files;
    const int depth = 10'000;
    for (int k = 0; k < depth; ++k)
        files["f" + std::to_string(k)] = "i 0 f" + std::to_string(k + 1);
    files["f" + std::to_string(depth)] = kTriangle;
    EXPECT_EQ(scene_of("i 0 f0", files).triangle_count(), 1u);
}

TEST(AffNesting, ReadsTracksWithAllTheirBlocks)
{
    std::string text = "x a{} k a { visibility 2 1 0 2.5 1";
    for (const char* block : {"transl", "scale"}) {
        text += std::string(" ") + block + " 4";
        for (int k = 0; k < 4; ++k) text += " " + std::to_string(k) + " 1 2 3 .1 .2 .3";
    }
    text += " rot 4";
    for (int k = 0; k < 4; ++k) text += " " + std::to_string(k) + " 0 2 0 180 0 0 0";
    const Scene scene = scene_of(text + "}");
    const std::vector<Channel>& channels = scene.clips.at(0).channels;
    ASSERT_EQ(channels.size(), 4u);
    const std::vector<TcbKey>& translation = channels[0].tcb;
    const std::vector<TcbKey>& rotation = channels[1].tcb;
    const std::vector<TcbKey>& scale = channels[2].tcb;
    EXPECT_EQ(channels[3].time_s.at(1), 1);
    EXPECT_EQ(channels[3].time_s.at(2), 2.5);
    EXPECT_EQ(channels[3].value, (std::vector<double>{1, 0, 1}));
    ASSERT_EQ(translation.size(), 4u);
    ASSERT_EQ(scale.size(), 4u);
    ASSERT_EQ(rotation.size(), 4u);
    EXPECT_EQ(scale[3].time_s, 3);
    EXPECT_EQ(glm::dvec3(scale[3].value), glm::dvec3(1, 2, 3));
    EXPECT_FLOAT_EQ(float(translation[1].tension), 0.1f);
    EXPECT_FLOAT_EQ(float(translation[1].continuity), 0.2f);
    EXPECT_FLOAT_EQ(float(translation[1].bias), 0.3f);
    EXPECT_NEAR(rotation[0].value.y, 1, 1e-15) << "normalised";
    EXPECT_NEAR(rotation[0].value.w, 0, 1e-15);
}

} // namespace
} // namespace firsthit
