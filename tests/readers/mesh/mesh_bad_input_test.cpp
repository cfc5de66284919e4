// mesh_bad_input_test.cpp - every damaged mesh file gives an error that says where.
#include "io/whole_file.h"

#include "message_of.h"
#include "readers/mesh/mesh_text.h"
#include "temporary_folder.h"

#include <random>

namespace firsthit::test {
namespace {

const std::string kVertices = "0 0 0\n1 0 0\n0 1 0\n";

TEST(MeshBadInput, NamesAMissingFile)
{
    EXPECT_EQ(message_of<FileError>([] { read_mesh_file("no/such/mesh.ply", {}); }),
        "no/such/mesh.ply: no such file");
}

TEST(MeshBadInput, RefusesAFolderAndADevice)
{
    const TemporaryFolder folder;
    EXPECT_THROW(read_whole_file(folder.path()), FileError);
    EXPECT_THROW(read_whole_file("/dev/zero"), FileError);
    EXPECT_THROW(read_whole_file(folder.write("a", "12345"), 4), FileError);
    EXPECT_EQ(read_whole_file(folder.write("a", "12345"), 5), "12345");
}

TEST(MeshBadInput, RefusesEmptyFiles)
{
    for (const char* const extension : {".ply", ".stl", ".obj"})
        expect_in(error_of<FileError>("", extension), "empty");
}

TEST(MeshBadInput, RefusesFilesWithoutTriangles)
{
    expect_in(error_of<FileError>("v 0 0 0\n", ".obj"), "no triangles");
    expect_in(error_of<FileError>("solid\nendsolid\n", ".stl"), "no triangles");
    expect_in(error_of<FileError>(binary_stl(0), ".stl"), "no triangles");
    expect_in(
        error_of<FileError>(ply_header("ascii", "3", "0") + kVertices, ".ply"), "no triangles");
}

TEST(MeshBadInput, RefusesBinaryStlWithoutAWholeFacet)
{
    const std::string whole = binary_stl(3);
    for (std::size_t size = 1; size < 84 + 50; ++size)
        error_of<FileError>(whole.substr(0, size), ".stl");
    expect_in(error_of<FileError>(whole.substr(0, 120), ".stl"), "3 facets, which makes 234 bytes");
}

TEST(MeshBadInput, RefusesEveryTruncatedBinaryPly)
{
    std::string whole = ply_header("binary_little_endian", "3", "1");
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(whole, value);
    append(whole, std::uint8_t(3));
    for (const int index : {0, 1, 2}) append(whole, index);
    EXPECT_EQ(read(whole, ".ply").triangle_count(), 1u);
    for (std::size_t size = 1; size < whole.size(); ++size)
        error_of<FileError>(whole.substr(0, size), ".ply");
}

TEST(MeshBadInput, RefusesATruncatedAsciiPlyAndNamesTheElement)
{
    expect_in(error_of<FileError>(ply_header("ascii", "3", "1") + "0 0 0\n1 0 0\n", ".ply"),
        "m.ply: the file ends at vertex 2 of 3: it is truncated, and has no triangles");
    expect_in(error_of<FileError>(ply_header("ascii", "3", "1") + kVertices + "3 0 1\n", ".ply"),
        "ends at face 0 of 1");
}

TEST(MeshBadInput, RefusesATruncatedAsciiStl)
{
    const std::string facet = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    expect_in(error_of<FileError>(facet, ".stl"), "truncated");
    expect_in(error_of<FileError>(facet + "endloop\n", ".stl"), "truncated");
}

TEST(MeshBadInput, RefusesCountsOfFourBillion)
{
    const std::string huge = "4294967295";
    expect_in(error_of<FileError>(ply_header("ascii", huge, "1") + kVertices, ".ply"), "truncated");
    expect_in(error_of<FileError>(ply_header("ascii", "3", huge) + kVertices, ".ply"), "truncated");
    expect_in(
        error_of<FileError>(ply_header("binary_little_endian", huge, huge) + kVertices, ".ply"),
        "truncated");
    expect_in(
        error_of<FileError>(ply_header("ascii", "4294967296", "1"), ".ply"), "4294967296 elements");
    expect_in(error_of<FileError>(ply_header("ascii", "-1", "1"), ".ply"), "-1 elements");
    std::string stl = binary_stl(1);
    stl.replace(80, 4, "\xFF\xFF\xFF\xFF");
    stl.replace(84, 4, "\xFF\xFF\xFF\xFF"); // no number: nothing says that it is an STL file
    expect_in(error_of<FileError>(stl, ".stl"), "4294967295 facets");
    expect_in(error_of<SceneError>("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967295\n", ".obj"),
        "m.obj:4: vertex index 4294967295 is out of range (3 so far)");
    expect_in(error_of<FileError>(
                  ply_header("ascii", "3", "1") + kVertices + "4000000000 0 1 2\n", ".ply"),
        "face 0: 4000000000 corners");
}

TEST(MeshBadInput, NamesAnIndexOutOfRange)
{
    const std::string header = ply_header("ascii", "3", "1") + kVertices;
    expect_in(error_of<SceneError>(header + "3 0 1 3\n", ".ply"),
        "m.ply:14: face 0: index 3 is out of range (3 vertices)");
    expect_in(error_of<SceneError>(header + "3 0 1 -1\n", ".ply"), "index -1");
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect_in(error_of<SceneError>(vertices + "f 0 1 2\n", ".obj"), "vertex index 0");
    expect_in(error_of<SceneError>(vertices + "f -4 1 2\n", ".obj"), "vertex index -4");
    expect_in(error_of<SceneError>("f 1 2 4\n" + vertices, ".obj"),
        "m.obj:1: vertex index 4 is out of range (3 vertices)");
}

TEST(MeshBadInput, NamesAWordThatIsNoNumber)
{
    expect_in(error_of<FileError>("v 0 0 0\nf 1 a 1\n", ".obj"), "m.obj:2: vertex index is 'a'");
    expect_in(error_of<FileError>("v 0 0 0\nf 1 1/ /1\n", ".obj"), "vertex index is '/1'");
    expect_in(error_of<FileError>("v 0 0 0\nf 1 1.5 1\n", ".obj"), "vertex index is '1.5'");
    expect_in(
        error_of<FileError>(ply_header("ascii", "3", "1") + kVertices + "3 0 1 2.5\n", ".ply"),
        "m.ply:14: an index or length is '2.5', a whole number");
    expect_in(error_of<FileError>(ply_header("ascii", "1", "1") + "0 x 0\n", ".ply"),
        "m.ply:11: a value is 'x', a number is needed");
    expect_in(error_of<FileError>("solid\nfacet\nvertex 0 1.5e 0\n", ".stl"),
        "m.stl:3: y is '1.5e', a number is needed");
}

TEST(MeshBadInput, RefusesAFaceOfMoreThanTheMostCorners)
{
    std::string face = "f";
    for (int k = 0; k <= 65536; ++k) face += " 1";
    expect_in(error_of<FileError>("v 0 0 0\n" + face, ".obj"), "more than 65536 corners");
}

TEST(MeshBadInput, ReadsAFaceOfTheMostCorners)
{
    std::string face = "\nf";
    for (int k = 0; k < 65536; ++k) face += " 1";
    EXPECT_EQ(read("v 0 0 0" + face, ".obj").triangle_count(), 65534u);
    std::string ply = ply_header("ascii", "1", "1") + "0 0 0\n65536";
    for (int k = 0; k < 65536; ++k) ply += " 0";
    EXPECT_EQ(read(ply, ".ply").triangle_count(), 65534u);
}

TEST(MeshBadInput, RefusesBrokenPlyHeaders)
{
    const auto header = [](const std::string& lines) { return "ply\nformat ascii 1.0\n" + lines; };
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string list = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string end = "end_header\n";
    const auto error = [](const std::string& bytes) { return error_of<FileError>(bytes, ".ply"); };
    expect_in(error("plx\n"), "first line is not 'ply'");
    expect_in(error("ply\nformat text 1.0\n"), "m.ply:2: format is 'text'");
    expect_in(error("ply\nelement vertex 1\n" + xyz + list + end), "no 'format'");
    expect_in(error(header("element vertex 1\n")), "no 'end_header'");
    expect_in(error(header("element vertex many\n")), "'many', a whole number");
    const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n";
    expect_in(error(binary + "property real x\n"), "'real' is no type");
    expect_in(error(header("property float x\n")), "before any element");
    expect_in(
        error(header("element vertex 1\nproperty float x\n" + list + end)), "no property 'y'");
    expect_in(error(header(list + end)), "there is no element 'vertex'");
    expect_in(error(header("element vertex 1\n" + xyz + end)), "cloud of 1 points");
    expect_in(error(header("element vertex 1\n" + xyz + "element face 1\nproperty int a\n" + end)),
        "no list 'vertex_indices'");
    expect_in(error(binary + xyz + "element face 1\nproperty list float int vertex_index\n" + end),
        "the length of a list must be a whole number");
    expect_in(error(header("element vertex 1\nproperty list uchar float x\nproperty float y\n"
                           "property float z\n" +
                           list + end)),
        "no property 'x'");
}

TEST(MeshBadInput, RefusesAFileInAnotherEncoding)
{
    const std::string utf16("\xFF\xFEv\0 \0"
                            "1\0 \0"
                            "2\0 \0"
                            "3\0\n\0",
        18);
    expect_in(error_of<FileError>(utf16, ".obj"), "m.obj: the text is UTF-16");
    error_of<FileError>(utf16, ".ply");
    error_of<FileError>(utf16, ".stl");
    EXPECT_EQ(
        read("\xEF\xBB\xBF# caf\xE9\n" + std::string(kCubeObj), ".obj").triangle_count(), 12u);
}

TEST(MeshBadInput, SurvivesGarbage)
{
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        std::string garbage(1 + random() % 400, '\0');
        for (char& c : garbage) c = static_cast<char>(random());
        for (const char* const extension : {".ply", ".stl", ".obj"})
            EXPECT_THROW(read(garbage, extension), Error) << round;
    }
}

TEST(MeshBadInput, SurvivesDamageToSoundFiles)
{
    std::mt19937 random(11);
    const std::string ply = ply_header("ascii", "3", "2") + kVertices + "3 0 1 2\n3 2 1 0\n";
    const std::pair<std::string, const char*> files[] = {
        {kCubeObj, ".obj"}, {ply, ".ply"}, {binary_stl(4), ".stl"}};
    for (int round = 0; round < 2000; ++round)
        for (const auto& [bytes, extension] : files) {
            std::string damaged = bytes;
            for (unsigned k = 0; k <= random() % 3; ++k)
                damaged[random() % damaged.size()] = static_cast<char>(random());
            try {
                EXPECT_GT(read(damaged, extension).triangle_count(), 0u);
            } catch (const Error&) {
                // An error of ours is as good as a scene.
            }
        }
}

} // namespace
} // namespace firsthit::test
