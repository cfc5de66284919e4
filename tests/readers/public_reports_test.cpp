// public_reports_test.cpp - files made after public reports of what other readers do wrong, each with its right
// values.
#include "readers/scene_parts.h"
#include "test_data.h"

#include <firsthit/npy.h>
#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <variant>

namespace firsthit::test {
namespace {

class PublicReports : public testing::Test {
  protected:
    void SetUp() override
    {
        if (!test_data("reports")) GTEST_SKIP() << "FIRSTHIT_TEST_DATA has no reports";
    }

    static std::string file(const std::string& name)
    {
        return (*test_data("reports") / name).string();
    }
    static Scene load(const std::string& name) { return load_scene(file(name)); }
};

void expect_red(const Scene& scene)
{
    ASSERT_FALSE(scene.color.empty());
    for (const glm::vec4& color : scene.color) EXPECT_EQ(color, glm::vec4(1, 0, 0, 1));
}

TEST_F(PublicReports, AConcavePolygonIsFilledToItsOutline)
{
    const Scene scene = load("obj_concave_polygon/a.obj");
    ASSERT_EQ(scene.triangle_count(), 4u);
    double area = 0;
    for (std::size_t t = 0; t < 4; ++t) {
        const glm::vec3 cross = glm::cross(
            corner(scene, t, 1) - corner(scene, t, 0), corner(scene, t, 2) - corner(scene, t, 0));
        EXPECT_GT(cross.z, 0) << "triangle " << t << " is turned over";
        area += 0.5 * cross.z;
    }
    EXPECT_EQ(area, 7); // of an L of 4 x 1 and 1 x 3
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, ATextureIsScaled)
{
    const Scene scene = load("mtl_scale_and_offset/a.obj");
    EXPECT_EQ(scene.textures.size(), 1u);
    std::set<std::pair<float, float>> uv;
    for (const glm::vec2& at : scene.uv) uv.emplace(at.x, at.y);
    EXPECT_EQ(uv, (std::set<std::pair<float, float>>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, ACommentThatEndsInABackslashEndsWithItsLine)
{
    const Scene scene = load("obj_comment_ends_in_backslash/a.obj");
    ASSERT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(0));
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 10, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, AMaterialLibraryMayHaveAByteOrderMark)
{
    const Scene scene = load("mtl_bom/a.obj");
    EXPECT_EQ(scene.triangle_count(), 2u);
    const Material& material = scene.materials[scene.instances[0].material];
    EXPECT_EQ(std::get<Phong>(material.model).diffuse, glm::vec3(1, 0, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, TextureCoordinatesThatAreNoNumbersCostOneWarning)
{
    const Scene scene = load("obj_nan_uv/a.obj");
    EXPECT_EQ(scene.triangle_count(), 2u);
    for (const glm::vec2& uv : scene.uv) EXPECT_EQ(uv, glm::vec2(0));
    EXPECT_NE(warning_of(scene).find("texture coordinates"), std::string::npos);
}

TEST_F(PublicReports, AStatementThatNobodyKnowsCostsOneWarning)
{
    const Scene scene = load("obj_unknown_statement/a.obj");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_NE(warning_of(scene).find("'c'"), std::string::npos);
}

TEST_F(PublicReports, ANormalOfIndexZeroIsComputed)
{
    const Scene scene = load("obj_normal_index_zero/a.obj");
    EXPECT_EQ(scene.triangle_count(), 2u);
    for (const glm::vec3& normal : scene.normal) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    EXPECT_NE(warning_of(scene).find("normals"), std::string::npos);
}

TEST_F(PublicReports, ColoursAreShown)
{
    for (const char* name :
        {"obj_vertex_colours/a.obj", "ply_vertex_colours/a.ply", "stl_colours/a.stl"}) {
        SCOPED_TRACE(name);
        const Scene scene = load(name);
        expect_red(scene);
        EXPECT_TRUE(scene.warnings.empty());
    }
}

TEST_F(PublicReports, PlyTextsAreWordsNotLines)
{
    const Scene scene = load("ply_wrapped_lines/a.ply");
    ASSERT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 1, 2), glm::vec3(0, 20, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, PlyStripsAreRead)
{
    const Scene scene = load("ply_tristrips/a.ply");
    ASSERT_EQ(scene.triangle_count(), 2u);
    // Both are seen from the same side.
    for (std::size_t t = 0; t < 2; ++t) {
        const glm::vec3 a = corner(scene, t, 0);
        EXPECT_NE(glm::cross(corner(scene, t, 1) - a, corner(scene, t, 2) - a).z, 0);
        EXPECT_GT(glm::cross(corner(scene, t, 1) - a, corner(scene, t, 2) - a).z *
                      glm::cross(corner(scene, 0, 1) - corner(scene, 0, 0),
                          corner(scene, 0, 2) - corner(scene, 0, 0))
                          .z,
            0);
    }
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, AVertexThatNoTriangleUsesMayBeNoNumber)
{
    const Scene scene = load("ply_nan_vertex_unused/a.ply");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(scene.vertex_count(), 4u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(PublicReports, TheLengthOfAnStlSaysHowManyFacetsItHas)
{
    const Scene scene = load("stl_count_zero/a.stl");
    EXPECT_EQ(scene.triangle_count(), 12u);
    EXPECT_NE(warning_of(scene).find("0 facets"), std::string::npos);
}

TEST_F(PublicReports, StlTextsAreWordsNotLines)
{
    for (const char* name : {"stl_tokens_not_lines/a.stl", "stl_tokens_not_lines/b.stl"}) {
        SCOPED_TRACE(name);
        const Scene scene = load(name);
        EXPECT_EQ(scene.triangle_count(), 12u);
        EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 1, 1));
        EXPECT_TRUE(scene.warnings.empty());
    }
}

TEST_F(PublicReports, ACubeHasFlatSides)
{
    const Scene scene = load("stl_cube_has_flat_sides/a.stl");
    ASSERT_EQ(scene.triangle_count(), 12u);
    for (const glm::uvec3& triangle : scene.index) {
        const glm::vec3 cross = glm::cross(scene.position[triangle.y] - scene.position[triangle.x],
            scene.position[triangle.z] - scene.position[triangle.x]);
        for (int k = 0; k < 3; ++k) EXPECT_EQ(scene.normal[triangle[k]], glm::normalize(cross));
    }
}

TEST_F(PublicReports, NpyArraysMayLieInFortranOrder)
{
    const std::vector<glm::vec3> points = read_npy_points(file("npy_fortran/p.npy"));
    EXPECT_EQ(points, (std::vector<glm::vec3>{{2, 0, 0}, {0, 0, 0}, {-2, 0, 0}, {-2, 0.5f, 0.5f}}));
}

TEST_F(PublicReports, AMaterialOfNineNumbersIsRead)
{
    const Scene scene = load("nff_nine_numbers/a.nff");
    EXPECT_EQ(scene.triangle_count(), 1u);
    const Material& material = scene.materials[scene.instances[0].material];
    EXPECT_EQ(std::get<Phong>(material.model).diffuse, glm::vec3(0.8f, 0, 0));
    EXPECT_NE(warning_of(scene).find("8"), std::string::npos);
}

TEST_F(PublicReports, NumbersOfTextsAreTheNearestFloats)
{
    const Scene scene = load("text_numbers/p.ply");
    ASSERT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(-2.15788327e-06f, -8.96605343e-05f, -0.000164333847f));
    EXPECT_EQ(corner(scene, 0, 1), glm::vec3(0.1f, 0.3f, 0.7f));
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(1.17549435e-38f, 123456.789f, 3.4e-39f));
}

} // namespace
} // namespace firsthit::test
