// aff_mesh_test.cpp - the mesh statement of AFF.
#include "readers/aff/aff_text.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

const std::string kSquare = "m vertices 4  0 0 0  1 0 0  1 1 0  0 1 0 ";

TEST(AffMesh, KeepsTheVerticesInFileOrderWhereTheStreamsAgree)
{
    const Scene scene =
        scene_of(kSquare + "normals 4 0 0 1 0 0 1 0 0 1 0 0 2 texturecoords 4 red.ppm "
                           "0 0 1 0 1 1 0 1 triangles 2 0 2 3 0 2 3 0 2 3 "
                           "0 1 2 0 1 2 0 1 2");
    ASSERT_EQ(scene.vertices, 4u);
    EXPECT_EQ(scene.position[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.uv[3], glm::vec2(0, 1));
    EXPECT_EQ(scene.normal[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.index, (std::vector<glm::uvec3>{{0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).texture, 0);
}

TEST(AffMesh, MakesVerticesOfCornersThatDiffer)
{
    // Positions 0 and 2 have one normal in the first triangle and another one in the second.
    const Scene scene =
        scene_of(kSquare + "normals 2 1 0 0 0 1 0 triangles 2 0 1 2 0 0 0 0 2 3 1 1 1");
    EXPECT_EQ(scene.vertices, 6u);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(scene.normal[scene.index[0][c]], glm::vec3(1, 0, 0));
        EXPECT_EQ(scene.normal[scene.index[1][c]], glm::vec3(0, 1, 0));
    }
    EXPECT_EQ(scene.position[scene.index[1].x], glm::vec3(0, 0, 0));
    EXPECT_EQ(scene.position[scene.index[1].y], glm::vec3(1, 1, 0));
}

TEST(AffMesh, ReadsTextureCoordinatesWithoutNormals)
{
    const Scene scene =
        scene_of(kSquare + "texturecoords 3 red.ppm 0 0 .5 0 1 1 triangles 1 1 2 3 0 1 2");
    EXPECT_EQ(scene.uv[scene.index[0].y], glm::vec2(0.5f, 0));
    EXPECT_EQ(scene.position[scene.index[0].y], glm::vec3(1, 1, 0));
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
}

TEST(AffMesh, IsFlatWithoutNormals)
{
    // A roof: two squares' halves that meet at an edge.
    const Scene scene = scene_of("m vertices 4 0 0 0 1 0 0 0 1 0 0 0 1 triangles 2 0 1 2 0 2 3");
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(scene.normal[scene.index[0][c]], glm::vec3(0, 0, 1));
        EXPECT_EQ(scene.normal[scene.index[1][c]], glm::vec3(1, 0, 0));
    }
}

TEST(AffMesh, LeavesOutVerticesThatNoTriangleUses)
{
    const Scene scene =
        scene_of("m vertices 5 9e9 0 0 0 0 0 1 0 0 0 1 0 -9e9 0 0 triangles 1 1 2 3");
    EXPECT_EQ(scene.vertices, 3u);
    EXPECT_EQ(scene.index[0], glm::uvec3(0, 1, 2));
}

TEST(AffMesh, MayBeEmpty)
{
    EXPECT_EQ(scene_of("m vertices 0 triangles 0").triangle_count(), 0u);
    EXPECT_EQ(scene_of(kSquare + "normals 0 triangles 1 0 1 2").triangle_count(), 1u);
}

TEST(AffMesh, TellsWhichVerticesAreThoseOfTheFile)
{
    std::vector<AffMeshRange> ranges;
    const std::string text =
        kTriangle + kSquare + "normals 2 1 0 0 0 1 0 triangles 2 0 1 2 0 0 0 0 2 3 1 1 1";
    const Scene scene = parse_aff("main.aff", text, {}, {}, &ranges);
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_EQ(ranges[0].first, 3u);
    EXPECT_EQ(ranges[0].count, 4u);
    EXPECT_EQ(scene.position[3 + 3], glm::vec3(0, 1, 0));
}

TEST(AffMesh, SurvivesAHubThatEachTriangleDressesAnew)
{
    // 20,000 triangles share a vertex, each with a normal of its own: quadratic work would show.
    const int n = 20'000;
    std::string text = "m vertices " + std::to_string(n + 2) + " 0 0 0";
    for (int k = 0; k <= n; ++k) text += " 1 " + std::to_string(k) + " 0";
    text += " triangles " + std::to_string(n);
    for (int k = 1; k <= n; ++k) text += " 0 " + std::to_string(k) + " " + std::to_string(k + 1);
    EXPECT_EQ(scene_of(text).triangle_count(), std::size_t(n));
}

} // namespace
} // namespace firsthit
