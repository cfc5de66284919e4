// aff_shapes_test.cpp - polygons, textured and animated triangles of AFF, and what shares an instance.
#include "readers/aff/aff_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit {
namespace {

TEST(AffShapes, FanPolygonsFromTheirFirstCorner)
{
    const Scene scene = scene_of("p 5 0 0 0 2 0 0 3 1 0 2 2 0 0 2 0");
    EXPECT_EQ(scene.vertices, 5u);
    EXPECT_EQ(scene.index, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    for (const glm::vec3& n : scene.normal) EXPECT_EQ(n, glm::vec3(0, 0, 1));
    EXPECT_TRUE(scene.uv.empty());
}

TEST(AffShapes, KeepThePolygonsNormalsAtUnitLength)
{
    const Scene scene = scene_of("pp 3 0 0 0 2 0 0  1 0 0 0 3 0  0 1 0 0 0 -4");
    EXPECT_EQ(scene.normal, (std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}));
}

TEST(AffShapes, TakeTheFlatNormalWhereANormalHasNoLength)
{
    EXPECT_EQ(scene_of("pp 3 0 0 0 0 0 0  1 0 0 0 0 0  0 1 0 0 0 0").normal[0], glm::vec3(0, 0, 1));
}

TEST(AffShapes, HaveSomeUnitNormalEvenWithoutArea)
{
    EXPECT_EQ(scene_of("p 3 1 1 1 1 1 1 1 1 1").normal[0], glm::vec3(0, 0, 1));
}

TEST(AffShapes, WearTextures)
{
    const Scene scene = scene_of("tt red.ppm 0 0 0 .1 .2 1 0 0 .3 .4 0 1 0 .5 .6\n"
                                 "ttp red.ppm 0 0 0 1 0 0 .1 .2 1 0 0 1 0 0 .3 .4 0 1 0 1 0 0 7 8");
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].name(), "red.ppm");
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).texture, 0);
    EXPECT_EQ(scene.instances.size(), 1u);
    ASSERT_EQ(scene.uv.size(), 6u);
    EXPECT_EQ(scene.uv[1], glm::vec2(0.3f, 0.4f));
    EXPECT_EQ(scene.uv[5], glm::vec2(7, 8));
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.normal[5], glm::vec3(1, 0, 0));
}

TEST(AffShapes, WearPicturesWhoseFirstRowIsAtTheBottom)
{
    const AffFiles files = {.include_text = {}, .texture = [](const std::string& name) {
                                const Picture levels[] = {{2, 3, {1, 2, 3, 4, 5, 6}}, {1, 1, {7}}};
                                return Texture(name, levels);
                            }};
    const Scene scene = parse_aff("main.aff", "tt a 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1", files, {});
    const Picture levels[] = {{2, 3, {5, 6, 3, 4, 1, 2}}, {1, 1, {7}}};
    EXPECT_TRUE(std::ranges::equal(scene.textures[0].texels(), Texture("b", levels).texels()));
    EXPECT_EQ(scene.uv[2], glm::vec2(0, 1));
}

TEST(AffShapes, HaveTextureCoordinatesForAllVerticesOrNone)
{
    const Scene scene =
        scene_of(kTriangle + "tt red.ppm 0 0 0 1 2 1 0 0 3 4 0 1 0 5 6 " + kTriangle);
    ASSERT_EQ(scene.uv.size(), 9u);
    EXPECT_EQ(scene.uv[2], glm::vec2(0));
    EXPECT_EQ(scene.uv[3], glm::vec2(1, 2));
    EXPECT_EQ(scene.uv[8], glm::vec2(0));
}

TEST(AffShapes, AreFlatColouredWithOneWarningWhereATextureIsMissing)
{
    const std::string textured = "tt gone.ppm 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\n";
    const Scene scene = scene_of(kTriangle + textured + textured + textured);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "main.aff:2: no texture 'gone.ppm', a plain colour instead: "
                                 "gone.ppm: no such file");
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_EQ(scene.instances.size(), 1u) << "the material is the plain one";
}

TEST(AffShapes, ShareAPartBetweenNeighboursOfOneNodeAndMaterial)
{
    const Scene scene = scene_of(kTriangle + kTriangle + "l 0 0 0 s 0 0 0 1 " + kTriangle +
                                 "xs 1 1 1 0 0 0 0 0 0 0 { " + kTriangle + "}" + kTriangle);
    ASSERT_EQ(scene.instances.size(), 3u);
    std::uint32_t vertex = 0, triangle = 0;
    for (std::size_t p = 0; p < 3; ++p) {
        EXPECT_EQ(scene.instances[p].first_vertex, vertex);
        EXPECT_EQ(scene.instances[p].first_triangle, triangle);
        for (std::uint32_t t = 0; t < scene.instances[p].triangle_count; ++t)
            EXPECT_EQ(scene.owner[triangle + t], p);
        vertex += scene.instances[p].vertex_count;
        triangle += scene.instances[p].triangle_count;
    }
    EXPECT_EQ(vertex, scene.vertices);
    EXPECT_EQ(triangle, scene.triangle_count());
}

std::string key(double time, double x)
{
    const std::string t = std::to_string(time), p = std::to_string(x);
    return t + " " + p + " 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 ";
}

TEST(AffShapes, AnimateTrianglesByTheirKeys)
{
    const Scene scene = scene_of("tpa 2 " + key(1, 5) + key(3, 7));
    ASSERT_EQ(scene.instances.size(), 1u);
    ASSERT_EQ(scene.instances[0].morph.size(), 2u);
    EXPECT_EQ(scene.instances[0].morph[1].time_s, 3);
    EXPECT_EQ(scene.instances[0].morph[1].position[0], glm::vec3(7, 0, 0));
    EXPECT_EQ(scene.position[0], glm::vec3(5, 0, 0)) << "the first key";
}

TEST(AffShapes, ShareAPartBetweenAnimatedTrianglesWithTheSameTimes)
{
    const Scene scene = scene_of("tpa 2 " + key(1, 5) + key(3, 7) + "tpa 2 " + key(1, 8) +
                                 key(3, 9) + "tpa 2 " + key(1, 5) + key(4, 7) + kTriangle);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances[0].triangle_count, 2u);
    EXPECT_EQ(scene.instances[0].morph[1].position.size(), 6u);
    EXPECT_EQ(scene.instances[0].morph[1].position[3], glm::vec3(9, 0, 0));
    EXPECT_TRUE(scene.instances[2].morph.empty());
}

} // namespace
} // namespace firsthit
