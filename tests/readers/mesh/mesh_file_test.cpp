// mesh_file_test.cpp - PLY, STL and OBJ files become the scenes they describe.
#include "scene/model/check_scene.h"

#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"
#include "test_data.h"

namespace firsthit::test {
namespace {

TEST(MeshFile, ReadsAnObjCubeAsTwelveTrianglesOfEightVertices)
{
    const Scene scene = read(kCubeObj, ".obj", {.crease_angle_rad = 4});
    EXPECT_EQ(scene.triangle_count(), 12u);
    EXPECT_EQ(scene.vertices, 8u);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(MeshFile, MakesAFanOfAFaceAroundItsFirstCorner)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 3 4 5 1 2\n", ".obj");
    ASSERT_EQ(scene.triangle_count(), 3u);
    for (std::size_t t = 0; t < 3; ++t) EXPECT_EQ(corner(scene, t, 0), glm::vec3(2, 1, 0));
    EXPECT_EQ(corner(scene, 0, 1), glm::vec3(1, 2, 0));
    EXPECT_EQ(corner(scene, 2, 2), glm::vec3(1, 0, 0));
}

TEST(MeshFile, NumbersVerticesInOrderOfFirstUse)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 3 4 2\nf 4 1 2\n", ".obj");
    ASSERT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(scene.index[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(scene.index[1], glm::uvec3(1, 3, 2));
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(1, 1, 0));
    EXPECT_EQ(corner(scene, 1, 1), glm::vec3(0, 0, 0));
}

TEST(MeshFile, KeepsTheFileOrderOfObjFacesOverObjectsGroupsAndMaterials)
{
    // Triangle k has its first corner at x = k; objects and materials come back.
    std::string obj;
    for (int k = 0; k < 8; ++k) obj += "v " + std::to_string(k) + " 0 0\n";
    obj += "v 0 1 0\nv 0 0 1\n";
    const char* const before[8] = {"", "o a\nusemtl red", "o b\nusemtl green", "g c", "o a",
        "usemtl red", "g c\nusemtl green", "o b\ns 1"};
    for (int k = 0; k < 8; ++k)
        obj += std::string(before[k]) + "\nf " + std::to_string(k + 1) + " 9 10\n";
    const Scene scene = read(obj, ".obj");
    ASSERT_EQ(scene.triangle_count(), 8u);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(corner(scene, k, 0).x, static_cast<float>(k));

    const char* const material[8] = {
        "grey", "red", "green", "green", "green", "red", "green", "green"};
    for (std::size_t k = 0; k < 8; ++k) {
        const Instance& instance = scene.instances[scene.owner[k]];
        EXPECT_EQ(scene.materials[instance.material].name, material[k]) << k;
    }
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(MeshFile, CountsNegativeObjIndicesBackwards)
{
    const Scene scene = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n", ".obj");
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(0, 0, 0));
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 1, 0));
}

TEST(MeshFile, LeavesOutVerticesThatNoTriangleUses)
{
    EXPECT_EQ(read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n", ".obj").vertices, 3u);
}

TEST(MeshFile, ReadsObjNumbersInEveryForm)
{
    const Scene scene = read(
        "v +1. -.5 2e1\nv 0.12345678901234567890123 00001 1E-50\nv 0 0 0\nf 01 +2 3\n", ".obj");
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(1, -0.5f, 20));
    EXPECT_EQ(corner(scene, 0, 1), glm::vec3(0.12345679f, 1, 0));
}

TEST(MeshFile, JoinsObjLinesAtABackslash)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 \\\n 1 0\r\nf 1 2\\\r\n 3\n", ".obj");
    EXPECT_EQ(corner(scene, 0, 2), glm::vec3(0, 1, 0));
}

TEST(MeshFile, SkipsPointsAndLinesWithAWarning)
{
    const Scene scene = read(std::string(kCubeObj) + "p 1\nl 1 2\nl 2 3\nf 1 2\n", ".obj");
    EXPECT_EQ(scene.triangle_count(), 12u);
    ASSERT_EQ(scene.warnings.size(), 2u);
    expect_in(scene.warnings[0], "points and lines are left out (first at line 15, 3 times)");
    expect_in(scene.warnings[1], "faces with fewer than 3 corners are left out (first at");
}

TEST(MeshFile, GivesDegenerateTrianglesTheirId)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 1\nf 1 2 2\nf 1 2 3\n", ".obj");
    ASSERT_EQ(scene.triangle_count(), 3u);
    EXPECT_EQ(corner(scene, 2, 2), glm::vec3(0, 1, 0));
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(MeshFile, UsesTheNormalsAndTextureCoordinatesOfAnObj)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nvt 0.5\nvn 0 3 4\n"
                             "f 1/1/1 2/2/1 3/1/1\n",
        ".obj");
    ASSERT_EQ(scene.uv.size(), 3u);
    EXPECT_EQ(scene.uv[0], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(scene.uv[1], glm::vec2(0.5f, 0));
    EXPECT_NEAR(scene.normal[0].y, 0.6f, 1e-6f);
    EXPECT_NEAR(scene.normal[0].z, 0.8f, 1e-6f);
}

TEST(MeshFile, MakesANormalWhereTheFilesIsZero)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n", ".obj");
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
}

TEST(MeshFile, SplitsVerticesAtATextureSeamButKeepsTheNormalSmooth)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 1\n"
                             "f 1/1 2/1 3/1\nf 1/2 4/2 2/2\n",
        ".obj", {.crease_angle_rad = 4});
    EXPECT_EQ(scene.vertices, 6u);
    const glm::uvec3 a = scene.index[0];
    const glm::uvec3 b = scene.index[1];
    EXPECT_NE(a.x, b.x);
    EXPECT_EQ(scene.normal[a.x], scene.normal[b.x]);
}

TEST(MeshFile, ReadsABinaryStl)
{
    const Scene scene = read(binary_stl(5), ".stl", {.crease_angle_rad = 4});
    ASSERT_EQ(scene.triangle_count(), 5u);
    EXPECT_EQ(scene.vertices, 11u); // neighbours share the corner on the x axis
    EXPECT_EQ(corner(scene, 3, 0), glm::vec3(3, 0, 0));
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
}

TEST(MeshFile, ReadsABinaryStlWhoseHeaderSaysSolid)
{
    std::string bytes = binary_stl(1);
    bytes.replace(0, 9, "solid obj");
    EXPECT_EQ(read(bytes, ".stl").triangle_count(), 1u);
}

TEST(MeshFile, ReadsAnAsciiStlInAnyCaseWithSeveralSolids)
{
    const Scene scene =
        read("SOLID a\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 0 0 0\n"
             "VERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID a\n"
             "solid\nendsolid\nsolid c\nfacet normal 0 0 1\nouter loop\n"
             "vertex 5 0 0\nvertex 6 0 0\nvertex 5 1 0\nendloop\nendfacet\nendsolid",
            ".stl");
    ASSERT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 1, 0), glm::vec3(5, 0, 0));
}

TEST(MeshFile, ReadsAnAsciiPlyWithUnknownPropertiesAndElements)
{
    const Scene scene = read(
        "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement vertex 4\r\nproperty uchar red\r\n"
        "property double x\r\nproperty float32 y\r\nproperty float z\r\nelement face 2\r\n"
        "property list uint8 float texcoord\r\nproperty list uchar uint vertex_index\r\n"
        "property int flags\r\nelement edge 1\r\nproperty int v\r\nend_header\r\n"
        "255 0 0 0\r\n0 1 0 0\r\n0 1 1 0\r\n0 0 1 0\r\n"
        "2 0.5 0.5 3 0 1 2 7\r\n0 4 0 1 2 3 7\r\n9\r\n",
        ".ply");
    ASSERT_EQ(scene.triangle_count(), 3u);
    EXPECT_EQ(corner(scene, 2, 2), glm::vec3(0, 1, 0));
}

TEST(MeshFile, ReadsBinaryPlyInBothByteOrders)
{
    // The bytes of the first coordinate read as line ends and blanks.
    const std::uint32_t bits = 0x0A0D200Au;
    float odd = 0;
    std::memcpy(&odd, &bits, sizeof odd);
    for (const bool big : {false, true}) {
        std::string bytes =
            ply_header(big ? "binary_big_endian" : "binary_little_endian", "4", "2");
        const auto put = [&](auto value) {
            std::string raw;
            append(raw, value);
            bytes += big ? std::string(raw.rbegin(), raw.rend()) : raw;
        };
        for (const float value : {odd, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
            put(value);
        put(std::uint8_t(3));
        for (const int index : {0, 1, 2}) put(index);
        put(std::uint8_t(4));
        for (const int index : {0, 1, 2, 3}) put(index);
        const Scene scene = read(bytes, ".ply");
        ASSERT_EQ(scene.triangle_count(), 3u);
        EXPECT_EQ(corner(scene, 0, 0), glm::vec3(odd, 0, 0));
        EXPECT_EQ(corner(scene, 2, 2), glm::vec3(0, 1, 0));
    }
}

TEST(MeshFile, ReadsABinaryPlyOfThreeMegabytes)
{
    // 3 MB of vertices and faces of 3 to 6 corners, with borders anywhere.
    constexpr int kVertices = 100'000;
    constexpr int kFaces = 90'000;
    std::string bytes = ply_header("binary_little_endian", "100000", "90000");
    for (int v = 0; v < kVertices; ++v)
        for (const int axis : {1, 2, 3}) append(bytes, static_cast<float>(v * axis) + 0.5f);
    const auto index = [](int face, int k) { return (face * 7919 + k * 104'729) % kVertices; };
    for (int f = 0; f < kFaces; ++f) {
        append(bytes, static_cast<std::uint8_t>(3 + f % 4));
        for (int k = 0; k < 3 + f % 4; ++k) append(bytes, index(f, k));
    }
    const Scene scene = read(bytes, ".ply");
    std::size_t triangle = 0;
    for (int f = 0; f < kFaces; ++f)
        for (int k = 2; k < 3 + f % 4; ++k, ++triangle)
            for (const auto& [place, from] : {std::pair{0, 0}, {1, k - 1}, {2, k}})
                ASSERT_EQ(
                    corner(scene, triangle, place).x, static_cast<float>(index(f, from)) + 0.5f);
    EXPECT_EQ(scene.triangle_count(), triangle);
}

TEST(MeshFile, ReadsNormalsAndTextureCoordinatesOfAPly)
{
    const Scene scene =
        read(ply_header("ascii", "3", "1",
                 "property float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
                 "property float t\n") +
                 "0 0 0 1 0 0 0.5 0.25\n1 0 0 1 0 0 0 0\n0 1 0 1 0 0 1 1\n3 0 1 2\n",
            ".ply");
    EXPECT_EQ(scene.normal[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.uv[0], glm::vec2(0.5f, 0.25f));
}

/// A scene that the set-up fetches, and how many triangles and vertices it has.
void expect_counts(const char* file, std::size_t triangles, std::size_t vertices)
{
    const std::filesystem::path path = std::filesystem::path(FIRSTHIT_SCENES) / file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " was not fetched";
    const Scene scene = read_mesh_file(path, {});
    EXPECT_EQ(scene.triangle_count(), triangles);
    EXPECT_EQ(scene.vertices, vertices);
    EXPECT_NO_THROW(check_scene(scene));
}

TEST(MeshFile, ReadsTheBunnyWithItsCounts)
{
    expect_counts("bunny.stl", 69451, 36023);
}

// Creases of 30 degrees split some vertices.
TEST(MeshFile, ReadsTheDragonWithItsCounts)
{
    expect_counts("dragon.ply", 871414, 444783);
}

TEST(MeshFile, ReadsTheGallopingHorseWithItsCounts)
{
    const auto path = test_data("horse-gallop/0001.obj");
    if (!path) GTEST_SKIP() << "FIRSTHIT_TEST_DATA has no horse-gallop/0001.obj";
    EXPECT_EQ(read_mesh_file(*path, {}).triangle_count(), 16843u);
}

} // namespace
} // namespace firsthit::test
