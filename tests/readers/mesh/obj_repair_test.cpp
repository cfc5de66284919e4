// obj_repair_test.cpp - OBJ files with faults are shown, and every fault is told of once.
#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"
#include "readers/mesh/raw_mesh.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace firsthit::test {
namespace {

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area(const Scene& scene)
{
    double sum = 0;
    for (const glm::uvec3& t : scene.index) {
        const glm::dvec3 a(scene.position[t.x]), b(scene.position[t.y]), c(scene.position[t.z]);
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
}

/// Reads a file with exactly one warning.
Scene read_with_warning(const std::string& obj, const std::string& warning)
{
    Scene scene = read(obj, ".obj");
    EXPECT_EQ(scene.warnings.size(), 1u) << obj;
    if (!scene.warnings.empty()) expect_in(scene.warnings[0], warning);
    return scene;
}

Scene read_silently(const std::string& obj)
{
    Scene scene = read(obj, ".obj");
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    return scene;
}

TEST(ObjRepair, SkipsUnknownStatementsWithAWarningAKind)
{
    const Scene scene = read(kCorners + "c 1.0 1.0 1.0\nvw 1\nc 2\n$ x\nf 1 2 3 4\nc\n", ".obj");
    EXPECT_EQ(scene.triangle_count(), 2u);
    ASSERT_EQ(scene.warnings.size(), 3u);
    expect_in(
        scene.warnings[0], "m.obj: unknown statements 'c' are left out (first at line 5, 3 times)");
    expect_in(scene.warnings[1], "'vw' are left out (first at line 6)");
    expect_in(scene.warnings[2], "'$'");
}

TEST(ObjRepair, ListsOnlyTheFirstKindsOfUnknownStatements)
{
    std::string obj = kCorners + "f 1 2 3\n";
    for (int k = 0; k < 1000; ++k) obj += "x" + std::to_string(k) + " 1\n";
    const Scene scene = read(obj, ".obj");
    ASSERT_EQ(scene.warnings.size(), 9u);
    expect_in(
        scene.warnings[8], "other unknown statements are left out (first at line 14, 992 times)");
}

TEST(ObjRepair, ReadsStatementsInCapitalsAndIndicesWithAPoint)
{
    const Scene capitals =
        read_silently("V 0 0 0\nV 1 0 0\nV 0 1 0\nVT 0.5 0\nVN 0 0 1\nF 1/1/1 2/1/1 3/1/1\n");
    EXPECT_EQ(capitals.uv.at(0), glm::vec2(0.5f, 0));
    EXPECT_EQ(
        read_silently(kCorners + "vt 0.5 0\nf 1.000000/1.0 2.0/1 -2.0 4.000\n").triangle_count(),
        2u);
    for (const char* index : {"1.5", "1.", "1.0e0", "1.0x"})
        expect_in(error_of<FileError>(kCorners + "f " + index + " 2 3\n", ".obj"),
            "a whole number is needed");
}

TEST(ObjRepair, SaysWhyNoTriangleIsLeft)
{
    expect_in(error_of<FileError>("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ".obj"),
        "no triangles in it: all have a corner that is no finite float");
}

TEST(ObjRepair, ReadsFacesThatStandBeforeTheirVertices)
{
    const Scene scene =
        read_silently("f 1/1/1 2/1/1 3/1/1\n" + kCorners + "vt 0.5 0.5\nvn 0 0 1\n");
    ASSERT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(1, 1, 0));
    EXPECT_EQ(scene.uv[scene.index[0].x], glm::vec2(0.5f));
}

TEST(ObjRepair, CountsNegativeIndicesFromWhereTheyStand)
{
    const Scene scene = read_silently(
        "v 5 5 5\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n" + kCorners + "f -4 -3 -2\n");
    ASSERT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 1, 0));
    EXPECT_EQ(corner(scene, 1, 2), glm::vec3(1, 1, 0));
}

TEST(ObjRepair, ReadsCornersOfAllFormsInOneFace)
{
    const Scene scene =
        read_silently(kCorners + "vt 0.25 0.75\nvn 0 3 4\nf 1 2/1 3//1 4/1/1\nf 1/ 2// 3/1/\n");
    ASSERT_EQ(scene.triangle_count(), 3u);
    const glm::uvec3 a = scene.index[0], b = scene.index[1];
    EXPECT_EQ(scene.uv[a.x], glm::vec2(0));
    EXPECT_EQ(scene.uv[a.y], glm::vec2(0.25f, 0.75f));
    EXPECT_NEAR(scene.normal[a.y].z, 1, 1e-6f); // computed
    EXPECT_NEAR(scene.normal[a.z].y, 0.6f, 1e-6f);
    EXPECT_NEAR(scene.normal[b.z].y, 0.6f, 1e-6f);
}

TEST(ObjRepair, ComputesNormalsThatDoNotExist)
{
    for (const char* const index : {"0", "2", "-2", "x", "99999999999999999999", "1.5"}) {
        const Scene scene =
            read_with_warning(kCorners + "vn 0 1 0\nf 1//" + index + " 2//1 3//1 4//1\n",
                "normals that do not exist");
        EXPECT_EQ(scene.normal[scene.index[0].x], glm::vec3(0, 0, 1)) << index;
        EXPECT_EQ(scene.normal[scene.index[0].y], glm::vec3(0, 1, 0)) << index;
    }
    // Where no face has one that exists.
    EXPECT_EQ(read_with_warning(kCorners + "f 1//1 2//2 3//3\n", "3 times").normal[0],
        glm::vec3(0, 0, 1));
}

TEST(ObjRepair, TakesZeroForTextureCoordinatesThatDoNotExist)
{
    for (const char* const index : {"0", "3", "-3", "x", "+"}) {
        const Scene scene =
            read_with_warning(kCorners + "vt 0.5 0.5\nvt 1 1\nf 1/" + index + " 2/1 3/2\n",
                "texture coordinates that do not exist are 0 (first at line 7)");
        EXPECT_EQ(scene.uv[scene.index[0].x], glm::vec2(0)) << index;
        EXPECT_EQ(scene.uv[scene.index[0].y], glm::vec2(0.5f)) << index;
    }
}

TEST(ObjRepair, TakesZeroForTextureCoordinatesThatAreNotFinite)
{
    for (const char* const bad :
        {"nan nan", "inf 0", "0 -1e99", "1.#QNAN 0", "x 0", "-nan(ind) 1"}) {
        const Scene scene =
            read_with_warning(kCorners + "vt " + bad + "\nvt 0.5 1\nf 1/1 2/2 3/2 4/2\n",
                "texture coordinates that are not finite numbers are 0 (first at line 5)");
        EXPECT_EQ(scene.uv[scene.index[0].x], glm::vec2(0)) << bad;
        EXPECT_EQ(scene.uv[scene.index[0].y], glm::vec2(0.5f, 1)) << bad;
    }
}

TEST(ObjRepair, ComputesNormalsThatAreNotFinite)
{
    const Scene scene = read_with_warning(kCorners + "vn nan 0 1\nf 1//1 2//1 3//1\n",
        "normals that are not finite numbers are computed");
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
}

TEST(ObjRepair, LeavesOutTrianglesWhosePositionIsNotFinite)
{
    for (const char* const bad : {"nan 0 0", "0 inf 0", "0 0 -1e39", "x 1 2", "1.#IND 0 0", ""}) {
        const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv " + std::string(bad) +
                                     "\nf 1 2 3\nf 1 2 4\nf 4 2 3\nf 3 2 1\n",
            ".obj");
        EXPECT_EQ(scene.triangle_count(), 2u) << bad;
        EXPECT_EQ(corner(scene, 1, 0), glm::vec3(0, 1, 0)) << bad;
        ASSERT_GE(scene.warnings.size(), 2u) << bad;
        expect_in(scene.warnings.back(),
            "triangles with a corner that is not finite are left out (first at line 6, 2 times)");
    }
    // In a polygon the triangles are left out that need it.
    EXPECT_EQ(read(kCorners + "v nan 0 0\nf 1 2 3 4 5\n", ".obj").triangle_count(), 2u);
    expect_in(
        error_of<FileError>("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ".obj"), "no triangles");
    // Not needed at all.
    read_with_warning(kCorners + "v nan 0 0\nf 1 2 3\n", "positions that are not finite numbers");
}

TEST(ObjRepair, KeepsRunsWhereTrianglesAreLeftOut)
{
    const Scene scene = read(kCorners + "v nan 0 0\nusemtl a\nf 1 2 3\nf 1 2 5\nusemtl b\nf 1 2 5\n"
                                        "usemtl c\nf 1 3 4\nf 3 4 1\n",
        ".obj");
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].triangle_count, 1u);
    EXPECT_EQ(scene.instances[1].triangle_count, 2u);
    EXPECT_EQ(scene.materials[scene.instances[1].material].name, "c");
}

TEST(ObjRepair, ReadsCommasAsPointsOrBlanks)
{
    for (const char* const line : {"v 1,5 -2,25 3", "v 1.5, -2.25, 3", "v 1.5,-2.25,3",
             "v 1.5 ,-2.25 , 3,", "v 1.5,-2.25 3", "v 1,5 -2,25 3,0"}) {
        const Scene scene = read_with_warning(
            std::string(line) + "\nv 0 0 0\nv 1 0 0\nf 1, 2,3\n", "commas in numbers");
        EXPECT_EQ(corner(scene, 0, 0), glm::vec3(1.5f, -2.25f, 3)) << line;
    }
    const Scene scene = read(kCorners + "vt 0,5 0,25\nvt 1,1\nf 1/1 2/2 3/2\n", ".obj");
    EXPECT_EQ(scene.uv[scene.index[0].x], glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(scene.uv[scene.index[0].y], glm::vec2(1, 1));
}

TEST(ObjRepair, EndsLinesInEveryWay)
{
    for (const char* const end : {"\n", "\r\n", "\r", "\n\r\n", " \t\r\n"}) {
        std::string obj;
        for (const char c : kCorners + "f 1 2 3\nf 1 3 4\n")
            obj += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(read_silently(obj).triangle_count(), 2u);
    }
    EXPECT_EQ(
        read_silently(kCorners + "f 1 2 3\n\rf 1 3 4\rf 1 2 4\r\nf 2 3 4").triangle_count(), 4u);
    expect_in(
        error_of<SceneError>(kCorners + "\r\n\rf 1 2 9\n", ".obj"), "m.obj:7: vertex index 9");
}

TEST(ObjRepair, EndsACommentWithItsLine)
{
    EXPECT_EQ(read_silently("#C:\\models\\\n" + kCorners + "f 1 2 3 # back\\\nf 1 3 4\n")
                  .triangle_count(),
        2u);
    EXPECT_EQ(read_silently("# a \\\r\n  #b\\\n" + kCorners + "f 1 2 \\\n 3\nf 1 \\\n2 \\\n3\\")
                  .triangle_count(),
        2u);
    EXPECT_EQ(read_silently(kCorners + "f 1 2 \\ \n 3\nf 1 2 3 \\\t").triangle_count(), 2u);
    // Lines are counted as they stand in the file.
    expect_in(
        error_of<SceneError>(kCorners + "f 1 \\\n2\\\n3\nf 1 2 9", ".obj"), "m.obj:8: vertex");
}

TEST(ObjRepair, FillsConcavePolygons)
{
    const std::string l = "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\n";
    for (const char* const face :
        {"f 1 2 3 4 5 6", "f 3 4 5 6 1 2", "f 6 5 4 3 2 1", "f 2 1 6 5 4 3"}) {
        const Scene scene = read_silently(l + face + "\n");
        EXPECT_EQ(scene.triangle_count(), 4u);
        EXPECT_NEAR(area(scene), 7, 1e-6) << face; // a fan has 9 or more, or folds over
    }
    EXPECT_EQ(read_with_warning("v 0 0 0\nv 9 9 0\nv 9 0 0\nv 0 4 0\nf 1 2 3 4\n", "crosses itself")
                  .triangle_count(),
        2u);
}

TEST(ObjRepair, ReadsVertexColoursAsSrgb)
{
    const RawMesh mesh =
        read_obj("v 0 0 0 1 0 0.5\nv 1 0 0\nv 0 1 0 0 1 0 7\nv 0 1 1 1\nf 1 2 3\n", "m.obj");
    ASSERT_EQ(mesh.color.size(), 4u);
    EXPECT_NEAR(mesh.color[0].b, 0.21404114f, 1e-6f);
    EXPECT_EQ(mesh.color[0].r, 1);
    EXPECT_EQ(mesh.color[1], glm::vec4(1));
    EXPECT_EQ(mesh.color[2], glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.color[3], glm::vec4(1)); // a weight
    EXPECT_TRUE(mesh.problems.empty());
    EXPECT_TRUE(read_obj(kCubeObj, "m.obj").color.empty());
}

TEST(ObjRepair, ReadsColoursOutOf255)
{
    const RawMesh mesh =
        read_obj("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 0 1 0 0 128 0\nf 1 2 3\n", "m.obj");
    EXPECT_EQ(mesh.color[0].r, 1);
    EXPECT_NEAR(mesh.color[2].g, 0.2158605f, 1e-6f);
    EXPECT_FALSE(mesh.problems.empty());
}

TEST(ObjRepair, ReadsColoursThatAreNotFiniteAsWhite)
{
    const RawMesh mesh =
        read_obj("v 0 0 0 nan 0 0\nv 1 0 0 0 0 0\nv 0 1 0 0 1 0\nf 1 2 3\n", "m.obj");
    EXPECT_EQ(mesh.color[0], glm::vec4(1));
    expect_in(mesh.problems.lines("m.obj").at(0), "vertex colours that are not finite numbers");
}

TEST(ObjRepair, ReadsTheColoursInZbrushsComments)
{
    const RawMesh mesh =
        read_obj(kCorners + "#MRGB ffff0000ff00ff00\n#MRGB ff0000ffffffffff\nf 1 2 3\n", "m.obj");
    ASSERT_EQ(mesh.color.size(), 4u);
    EXPECT_EQ(mesh.color[0], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.color[2], glm::vec4(0, 0, 1, 1));
    EXPECT_TRUE(mesh.problems.empty());
    EXPECT_FALSE(read_obj(kCorners + "#MRGB ffff0000zz\nf 1 2 3\n", "m.obj").problems.empty());
}

TEST(ObjRepair, MakesAnInstanceOfEachObjectGroupAndMaterial)
{
    const Scene scene =
        read_silently(kCorners + "f 1 2 3\no box\nf 1 2 3\ng side\nf 1 2 3\ng side\nf 2 3 4\n"
                                 "o ball\nf 1 2 3\ng\nf 1 2 3\no ball\nf 1 2 4\n");
    ASSERT_EQ(scene.instances.size(), 4u);
    const std::pair<const char*, std::uint32_t> expected[] = {
        {"grey", 1}, {"box", 1}, {"box/side", 2}, {"ball", 3}};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(scene.instances[k].name, expected[k].first);
        EXPECT_EQ(scene.instances[k].triangle_count, expected[k].second);
    }
}

TEST(ObjRepair, TakesTenThousandGroupsQuickly)
{
    std::string obj = kCorners;
    for (int k = 0; k < 10000; ++k) obj += "g part" + std::to_string(k) + "\nf 1 2 3\n";
    EXPECT_EQ(read_silently(obj).instances.size(), 10000u);
}

TEST(ObjRepair, TellsOnlyMaterialsApartWhereThereAreTooManyGroups)
{
    std::string obj = kCorners;
    for (int k = 0; k < 70000; ++k) {
        if (k % 35000 == 0) obj += "usemtl m" + std::to_string(k) + "\n";
        obj += "g part" + std::to_string(k) + "\nf 1 2 3\n";
    }
    const Scene scene = read(obj, ".obj");
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[1].name, "m35000");
    EXPECT_EQ(scene.instances[1].triangle_count, 35000u);
    expect_in(scene.warnings.at(0), "more than 65536 objects and groups");
}

TEST(ObjRepair, CutsLongNames)
{
    const std::string obj = kCorners + "usemtl " + std::string(1000, 'm') + "\ng " +
                            std::string(1000, 'g') + "\nf 1 2 3\ng\nf 1 2 3\n";
    const Scene scene = read(obj, ".obj");
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].name, std::string(256, 'g'));
    EXPECT_EQ(scene.instances[1].name, std::string(256, 'm'));
}

TEST(ObjRepair, EndsNumbersAndCornersAtAComment)
{
    const Scene scene =
        read_silently("v 0 0 0#a\nv 1 0 0 #b\nv 0 1 2#c\nf 1 2 3#1 2 3\nf 1/ 2 3/#\n");
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 1, 2));
}

TEST(ObjRepair, TellsOfWhatIsNotShown)
{
    read_with_warning(
        kCorners + "f 1 2 3\np 1\nl 1 2\n", "points and lines are left out (first at line 6");
    read_with_warning(kCorners + "f 1 2 3\ncurv 0 1 1 2 3\nsurf 0 1 0 1 1\n", "free-form curves");
    read_with_warning(
        kCorners + "f 1 2 3\ncall x.obj\ncsh rm -rf x\n", "'call' and 'csh' are not followed");
    read_with_warning(kCorners + "v 1 2\nf 1 2 3\n", "missing coordinates are 0 (first at line 5)");
    read_with_warning(kCorners + "vn 0 0 1\nvt 1 1\nf 1/1/1/7 2 3\n", "more than v/vt/vn");
}

TEST(ObjRepair, RefusesWhatHasNothingToShow)
{
    expect_in(error_of<FileError>("v 0 0 0\nv 1 0 0\n", ".obj"),
        "no triangles in it: 2 vertices and no faces");
    expect_in(error_of<FileError>("<html>\n", ".obj"), "no triangles");
    for (const std::string& start : {std::string("\xFF\xFEv\0", 4), std::string("\xFE\xFF\0v", 4)})
        expect_in(error_of<FileError>(start, ".obj"), "the text is UTF-16; UTF-8");
}

TEST(ObjRepair, SkipsAByteOrderMark)
{
    EXPECT_EQ(read_silently("\xEF\xBB\xBF" + std::string(kCubeObj)).triangle_count(), 12u);
}

} // namespace
} // namespace firsthit::test
