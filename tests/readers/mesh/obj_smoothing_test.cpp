// obj_smoothing_test.cpp - smoothing groups of OBJ files decide where edges are sharp.
#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"

#include <glm/geometric.hpp>

#include <string>

namespace firsthit::test {
namespace {

/// A roof of two faces that meet at an edge of 90 degrees: (0, 0, 1) to (1, 0, 1).
const std::string kRoof = "v 0 -1 0\nv 1 -1 0\nv 1 0 1\nv 0 0 1\nv 1 1 0\nv 0 1 0\n";
const std::string kFront = "f 1 2 3 4\n", kBack = "f 4 3 5 6\n";

/// Whether all corners at the roof's edge share a normal, which points upwards then; else they have the faces' own.
bool is_smooth(const std::string& obj, double crease_angle_rad = 0.5)
{
    const Scene scene = read(kRoof + obj, ".obj", {.crease_angle_rad = crease_angle_rad});
    EXPECT_EQ(scene.triangle_count(), 4u);
    EXPECT_TRUE(scene.warnings.empty());
    int smooth = 0, corners = 0;
    for (std::size_t t = 0; t < 4; ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t v = scene.index[t][k];
            if (scene.position[v].z != 1) continue;
            ++corners;
            const glm::vec3 face = glm::normalize(glm::vec3(0, t < 2 ? -1 : 1, 1));
            const bool up = glm::distance(scene.normal[v], glm::vec3(0, 0, 1)) < 1e-6f;
            const bool own = glm::distance(scene.normal[v], face) < 1e-6f;
            EXPECT_TRUE(up != own);
            smooth += up;
        }
    EXPECT_TRUE(smooth == 0 || smooth == corners);
    return smooth > 0;
}

TEST(ObjSmoothing, FacesOfOneGroupAreSmoothHoweverSharpTheEdgeIs)
{
    EXPECT_TRUE(is_smooth("s 1\n" + kFront + kBack));
    EXPECT_TRUE(is_smooth("s on\n" + kFront + kBack));
    EXPECT_TRUE(is_smooth("s 7\n" + kFront + "s 1\ns 7\n" + kBack));
}

TEST(ObjSmoothing, EdgesAreSharpBetweenGroupsAndWhereItIsOff)
{
    constexpr double kAll = 3.2; // all edges are smooth by their angle
    EXPECT_FALSE(is_smooth("s 1\n" + kFront + "s 2\n" + kBack, kAll));
    EXPECT_FALSE(is_smooth("s off\n" + kFront + kBack, kAll));
    EXPECT_FALSE(is_smooth("s 0\n" + kFront + kBack, kAll));
    EXPECT_FALSE(is_smooth("s 1\n" + kFront + "s off\n" + kBack, kAll));
}

TEST(ObjSmoothing, TheAngleDecidesWithoutGroupsAndBeforeTheFirst)
{
    for (const std::string rest : {"", "s 1\n"}) {
        EXPECT_FALSE(is_smooth(kFront + kBack + rest));
        EXPECT_TRUE(is_smooth(kFront + kBack + rest, 2));
    }
    EXPECT_FALSE(is_smooth(kFront + "s 1\n" + kBack, 2));
}

TEST(ObjSmoothing, NormalsOfTheFileGoBeforeIt)
{
    const Scene scene =
        read(kRoof + "vn 1 0 0\ns 1\nf 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1 6//1\n", ".obj");
    for (const glm::vec3& normal : scene.normal) EXPECT_EQ(normal, glm::vec3(1, 0, 0));
}

TEST(ObjSmoothing, AGroupThatIsNoNumberIsLeftOutWithAWarning)
{
    const Scene scene = read(kRoof + "s 1\ns smooth\n" + kFront + kBack, ".obj");
    expect_in(warning_of(scene),
        "smoothing groups that are neither a number nor off are left out (first at line 8)");
    EXPECT_EQ(scene.vertex_count(), 8u); // the edge is sharp by its angle
}

TEST(ObjSmoothing, GroupsStayWithTheirTrianglesWhereOthersAreLeftOut)
{
    EXPECT_EQ(
        read(kRoof + "v nan 0 0\ns off\nf 1 2 7\ns 1\n" + kFront + kBack, ".obj").vertex_count(),
        6u);
}

} // namespace
} // namespace firsthit::test
