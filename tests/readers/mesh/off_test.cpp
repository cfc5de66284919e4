// off_test.cpp - OFF files become the meshes they describe.
#include "readers/mesh/mesh_text.h"
#include "readers/mesh/raw_mesh.h"
#include "scene/model/check_scene.h"

#include <string>

namespace firsthit::test {
namespace {

const std::string kOffTriangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(OffFile, ReadsPolygonsAsFans)
{
    const Scene scene =
        read("OFF\n5 2 7\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 2 3 4 0 1\n3 0 1 2\n", ".off");
    ASSERT_EQ(scene.triangle_count(), 4u);
    EXPECT_EQ(scene.position[scene.index[0][0]], glm::vec3(2, 1, 0));
    EXPECT_EQ(scene.position[scene.index[2][1]], glm::vec3(0, 0, 0));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(OffFile, LinesAndCommentsMayBeAnywhereBetweenNumbers)
{
    for (const char* text : {"OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
             "# made by hand\nOFF # the kind\n\n3\n1 0 # counts\n0 0\n0\n1 0 0\n\n0 1 0\n3 0\n1 2",
             "\xEF\xBB\xBFOFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
             "OFF\n3 1\n0 0 0\n1 0 "
             "0\n0 1 0\n3 0 1 2\n"}) {
        const RawMesh mesh = read_off(text, "m.off");
        EXPECT_EQ(mesh.position.size(), 3u) << text;
        EXPECT_EQ(mesh.position[1], glm::vec3(1, 0, 0)) << text;
        ASSERT_EQ(mesh.index.size(), 1u) << text;
        EXPECT_EQ(mesh.index[0], glm::uvec3(0, 1, 2)) << text;
    }
}

TEST(OffFile, ReadsNormalsColoursAndTextureCoordinates)
{
    const RawMesh mesh = read_off("STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 0 128  0.25 0.75\n"
                                  "1 0 0  0 1 0  0.0 1.0 0.0  1 0\n0 1 0  1 0 0  0 0 255  0 1\n"
                                  "3 0 1 2\n",
        "m.off");
    EXPECT_EQ(mesh.normal[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.uv[0], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.color[0], glm::vec4(1, 0, 0, 128 / 255.0f));
    EXPECT_EQ(mesh.color[1], glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.color[2], glm::vec4(0, 0, 1, 1));
}

TEST(OffFile, ReadsColoursOfFaces)
{
    const RawMesh mesh =
        read_off("OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3 255 0 0\n"
                 "3 0 2 3 7\n",
            "m.off");
    const glm::vec4 white(1), red(1, 0, 0, 1);
    EXPECT_EQ(mesh.triangle_color, (std::vector<glm::vec4>{white, red, red, white}));
    EXPECT_TRUE(read_off(kOffTriangle, "m.off").triangle_color.empty());
}

TEST(OffFile, FacesOfFewerThanThreeCornersAreLeftOutWithAWarning)
{
    const Scene scene = read("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 0\n", ".off");
    EXPECT_EQ(scene.triangle_count(), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(scene.warnings[0], "fewer than 3 corners");
}

const std::string kQuad = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(OffFile, TakesTheFirstWordAsProgramsWriteIt)
{
    for (const std::string first : {"OFF\n", "off\n", "Off ", "OFF"}) { // the last is "OFF4 1 0"
        SCOPED_TRACE(first);
        const Scene scene = read(first + "4 1 0\n" + kQuad + "4 0 1 2 3\n", ".off");
        EXPECT_EQ(scene.triangle_count(), 2u);
        EXPECT_TRUE(scene.warnings.empty());
    }
    const Scene scene = read("4 1 0\n" + kQuad + "4 0 1 2 3\n", ".off");
    EXPECT_EQ(scene.triangle_count(), 2u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "m.off: the word OFF is missing (first at line 1)");
}

TEST(OffFile, LeavesOutTrianglesWhoseCornersAreNoNumbers)
{
    for (const char* word : {"nan", "-nan(ind)", "1.#QNAN", "inf", "1e99"}) {
        SCOPED_TRACE(word);
        const Scene scene =
            read("OFF\n5 2 0\n" + kQuad + word + " 0 0\n3 0 1 4\n4 0 1 2 3\n", ".off");
        EXPECT_EQ(scene.triangle_count(), 2u);
        ASSERT_EQ(scene.warnings.size(), 1u);
        expect_in(scene.warnings[0], "no finite float");
    }
}

TEST(OffFile, ShowsWhatIsThereWhereTheCountIsWrong)
{
    const Scene few = read("OFF\n4 9 0\n" + kQuad + "4 0 1 2 3\n", ".off");
    EXPECT_EQ(few.triangle_count(), 2u);
    ASSERT_EQ(few.warnings.size(), 1u);
    EXPECT_EQ(few.warnings[0], "m.off: the file ends at face 1 of 9: the rest is missing");
    const Scene more = read("OFF\n4 1 0\n" + kQuad + "4 0 1 2 3\n3 0 1 2\n", ".off");
    EXPECT_EQ(more.triangle_count(), 2u);
    ASSERT_EQ(more.warnings.size(), 1u);
    EXPECT_EQ(more.warnings[0], "m.off: words behind the last face are left out (first at line 8)");
}

TEST(OffFile, LeavesOutSpareNumbersOfVertices)
{
    const Scene scene = read("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 1 2\n# x\n0 1 0 0 0 2\n"
                             "3 0 1 2\n",
        ".off");
    ASSERT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(scene.position[scene.index[0][2]], glm::vec3(0, 1, 0));
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(
        scene.warnings[0], "spare numbers of vertices are left out (first at line 3, 3 times)");
    // Two vertices on a line are no such thing.
    const Scene pairs = read("OFF\n4 1 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1 2 3\n", ".off");
    EXPECT_EQ(pairs.triangle_count(), 2u);
    EXPECT_TRUE(pairs.warnings.empty());
}

TEST(OffFile, ForgivesWrongColoursAndTextureCoordinates)
{
    const Scene scene = read("STCOFF\n3 2 0\n0 0 0 1 0.5\n1 0 0 x 0 0 1 1\n0 1 0 1 0 0 y 1\n"
                             "3 0 1 2 red green blue\n3 0 1 2\n",
        ".off");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(scene.warnings.size(), 3u);
    for (const glm::vec4& color : scene.color) EXPECT_TRUE(color == glm::vec4(1) || color.g == 0);
}

TEST(OffFile, FillsConcavePolygons)
{
    // An L, whose fan around the first corner covers more than it.
    const RawMesh mesh = read_off("OFF\n6 1 0\n4 1 0\n1 1 0\n1 4 0\n0 4 0\n0 0 0\n4 0 0\n"
                                  "6 0 1 2 3 4 5 0 255 0\n",
        "m.off");
    double area = 0;
    for (const glm::uvec3& t : mesh.index) {
        const glm::vec3 a = mesh.position[t.x], b = mesh.position[t.y], c = mesh.position[t.z];
        const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        EXPECT_GT(twice, 0);
        area += twice / 2;
    }
    EXPECT_EQ(area, 7);
    EXPECT_EQ(mesh.triangle_color, std::vector<glm::vec4>(4, glm::vec4(0, 1, 0, 1)));
}

TEST(OffFile, SaysWhereAndWhatIsWrong)
{
    const auto replaced = [](const std::string& from, const std::string& to) {
        std::string text = kOffTriangle;
        return text.replace(text.find(from), from.size(), to);
    };
    expect_in(error_of<FileError>("", ".off"), "the file is empty");
    expect_in(error_of<FileError>("PLY\n", ".off"), "m.off:1: 'PLY' is no kind of OFF file");
    expect_in(error_of<FileError>("4OFF\n3 1 0\n", ".off"), "'4OFF' is no kind of OFF file");
    expect_in(error_of<FileError>("OFF BINARY\n", ".off"), "binary OFF files are not read");
    expect_in(error_of<FileError>("OFF\n3 1 0\n0 0 0\n", ".off"),
        "the file ends where there should be: x");
    expect_in(error_of<FileError>(replaced("3 1 0", "x 1 0"), ".off"),
        "m.off:2: number of vertices is 'x', a whole number is needed");
    expect_in(
        error_of<FileError>(replaced("3 1 0", "-3 1 0"), ".off"), "number of vertices is '-3'");
    expect_in(error_of<FileError>(replaced("3 1 0", "4000000000 1 0"), ".off"),
        "number of vertices is 4000000000, more than a file of");
    expect_in(error_of<FileError>(replaced("3 0 1 2", "99999 0 1 2"), ".off"),
        "m.off:6: number of corners is '99999', a whole number up to 65536");
    expect_in(error_of<SceneError>(replaced("3 0 1 2", "3 0 1 3"), ".off"),
        "m.off:6: vertex 3 is out of range (3 vertices)");
    expect_in(error_of<SceneError>(replaced("3 0 1 2", "3 0 1 -1"), ".off"), "vertex -1");
    expect_in(error_of<FileError>(replaced("1 0 0", "1 nan 0"), ".off"),
        "no triangles in it: all 1 have a corner that is no finite float");
    expect_in(error_of<FileError>(replaced("1 0 0", "1 a 0"), ".off"), "m.off:4: y is 'a'");
    expect_in(error_of<FileError>("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", ".off"), "no triangles");
}

} // namespace
} // namespace firsthit::test
