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
    expect_in(error_of<SceneError>(replaced("1 0 0", "1 nan 0"), ".off"),
        "m.off:4: y is 'nan', a finite number is needed");
    expect_in(error_of<FileError>(replaced("1 0 0", "1 a 0"), ".off"), "m.off:4: y is 'a'");
    expect_in(error_of<FileError>("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", ".off"), "no triangles");
    expect_in(error_of<FileError>("COFF\n1 1 0\n0 0 0 1 2\n", ".off"), "a colour of three or four");
    expect_in(error_of<FileError>("STOFF\n1 1 0\n0 0 0 1\n", ".off"), "two texture coordinates");
}

} // namespace
} // namespace firsthit::test
