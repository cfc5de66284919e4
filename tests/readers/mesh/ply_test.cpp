// ply_test.cpp - PLY files as programs write them: what is shown, what is left out, what is refused.
#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"
#include "base/srgb.h"

#include "temporary_folder.h"

#include <fmt/format.h>

#include <cmath>

namespace firsthit::test {
namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";
const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ascii(const std::string& elements, const std::string& body)
{
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

glm::vec4 color_at(const Scene& scene, std::size_t triangle, int k)
{
    return scene.color[scene.index[triangle][k]];
}

/// The same triangles with the same attributes, to the bit.
void expect_same(const Scene& a, const Scene& b)
{
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.uv, b.uv);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.index, b.index);
}

TEST(Ply, ReadsWordsWhateverTheLinesAre)
{
    const std::string header = ply_header("ascii", "4", "2");
    const Scene lines = read(header + kSquare + "3 0 1 2\n3 0 2 3\n", ".ply");
    expect_same(read(header + "0\n0 0 1\n\n0\t0 1 1 0 0 1 0 3 0 1 2 3 0 2 3", ".ply"), lines);
    expect_same(read(header + "0 0 0\r1 0 0\r1 1 0\r0 1 0\r3 0 1 2\r3 0 2 3\r", ".ply"), lines);
    expect_same(read(header + "\n" + kSquare + "\n\n3 0 1 2\n3 0 2 3\n\n", ".ply"), lines);
    EXPECT_TRUE(lines.warnings.empty());
}

TEST(Ply, ReadsTextInPartsAsWordByWord)
{
    // 1.5 MB: several parts. A blank line makes the reader go word by word.
    std::string vertices, faces;
    constexpr int kPoints = 40'000;
    for (int v = 0; v < kPoints; ++v)
        vertices += fmt::format("{} {:.7g} {}e-1\n", v % 200, 1e-3 * std::sin(v * 0.7), v / 200);
    for (int f = 0; f + 201 < kPoints; ++f)
        faces += f % 5 == 0 ? fmt::format("4 {} {} {} {}\n", f, f + 1, f + 201, f + 200)
                            : fmt::format("3 {} {} {}\n", f, f + 1, f + 201);
    const std::string header =
        ply_header("ascii", std::to_string(kPoints), std::to_string(kPoints - 201));
    const Scene parts = read(header + vertices + faces, ".ply");
    EXPECT_TRUE(parts.warnings.empty());
    EXPECT_GT(parts.triangle_count(), std::size_t(kPoints));
    expect_same(read(header + vertices + "\n" + faces, ".ply"), parts);
    // Without the last line's end.
    faces.pop_back();
    expect_same(read(header + vertices + faces, ".ply"), parts);
}

TEST(Ply, TextAndBinaryCopiesAreEqualToTheBit)
{
    const float values[] = {0.1f, 1e-40f, 3.4028235e38f, -0.0f, 16777217.0f, 1.17549435e-38f,
        7.0f / 3, 1e-7f, 123456.79f};
    std::string text = ply_header("ascii", "3", "1"),
                binary = ply_header("binary_little_endian", "3", "1");
    for (std::size_t k = 0; k < std::size(values); ++k) {
        text += fmt::format("{}{}", values[k], k % 3 == 2 ? "\n" : " ");
        append(binary, values[k]);
    }
    text += "3 0 1 2\n";
    append(binary, std::uint8_t(3));
    for (const int index : {0, 1, 2}) append(binary, index);
    expect_same(read(text, ".ply"), read(binary, ".ply"));
}

TEST(Ply, TakesElementsInAnyOrderAndSkipsOthers)
{
    const Scene scene =
        read(ascii("element face 2\n" + kList +
                       "element edge 2\nproperty int a\nproperty list "
                       "uchar float b\n" +
                       "element vertex 4\n" + kXyz + "element material 1\nproperty uchar k\n",
                 "3 0 1 2\n3 0 2 3\n7 2 1.5 nan\n8 0\n" + kSquare + "9\n"),
            ".ply");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 1, 2), glm::vec3(0, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Ply, TakesBinaryElementsInAnyOrder)
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement face 1\n" + kList +
                        "element tags 1\nproperty list uint double t\nelement vertex 3\n" + kXyz +
                        "end_header\n";
    append(bytes, std::uint8_t(3));
    for (const int index : {2, 1, 0}) append(bytes, index);
    append(bytes, 2u);
    append(bytes, 1.0);
    append(bytes, 2.0);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, x);
    const Scene scene = read(bytes, ".ply");
    EXPECT_EQ(corner(scene, 0, 0), glm::vec3(0, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Ply, SkipsListsOfVertices)
{
    const std::string elements =
        "element vertex 3\nproperty list uchar int tags\n" + kXyz + "element face 1\n" + kList;
    const Scene text = read(ascii(elements, "2 5 6 0 0 0\n0 1 0 0\n1 9 0 1 0\n3 0 1 2\n"), ".ply");
    std::string bytes = "ply\nformat binary_big_endian 1.0\n" + elements + "end_header\n";
    const auto put = [&](auto value) {
        std::string raw;
        append(raw, value);
        bytes.append(raw.rbegin(), raw.rend());
    };
    for (int v = 0; v < 3; ++v) {
        put(std::uint8_t(v));
        for (int k = 0; k < v; ++k) put(k);
        put(v == 1 ? 1.0f : 0.0f);
        put(v == 2 ? 1.0f : 0.0f);
        put(0.0f);
    }
    put(std::uint8_t(3));
    for (const int index : {0, 1, 2}) put(index);
    expect_same(read(bytes, ".ply"), text);
}

TEST(Ply, ReadsStripsWithRestarts)
{
    const Scene scene = read(ascii("element vertex 4\n" + kXyz +
                                       "element tristrips 1\nproperty list int int vertex_index\n",
                                 kSquare + "11 0 1 3 2 -1 2 1 0 -1 3 -1\n"),
        ".ply");
    ASSERT_EQ(scene.triangle_count(), 3u);
    // Every second triangle is turned round, so that all face the same side.
    for (std::size_t t = 0; t < 2; ++t)
        EXPECT_EQ(scene.normal[scene.index[t].x], glm::vec3(0, 0, 1)) << t;
    EXPECT_EQ(corner(scene, 1, 0), glm::vec3(0, 1, 0));
    EXPECT_EQ(corner(scene, 2, 0), glm::vec3(1, 1, 0));
    EXPECT_EQ(scene.normal[scene.index[2].x], glm::vec3(0, 0, -1));
    expect_in(error_of<SceneError>(ascii("element vertex 4\n" + kXyz + "element tristrips 1\n" +
                                             "property list int int vertex_index\n",
                                       kSquare + "3 0 1 4\n"),
                  ".ply"),
        "m.ply:14: strip 0: index 4 is out of range (4 vertices)");
}

TEST(Ply, CutsAConcaveFaceIntoItsOwnArea)
{
    // An L of area 3.
    const Scene scene = read(
        ply_header("ascii", "6", "1") + "2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n6 0 1 2 3 4 5\n",
        ".ply");
    ASSERT_EQ(scene.triangle_count(), 4u);
    double area = 0;
    for (std::size_t t = 0; t < 4; ++t) {
        const glm::vec3 n = glm::cross(
            corner(scene, t, 1) - corner(scene, t, 0), corner(scene, t, 2) - corner(scene, t, 0));
        EXPECT_GE(n.z, 0);
        area += n.z / 2;
    }
    EXPECT_EQ(area, 3);
}

TEST(Ply, LeavesOutTrianglesWithACornerThatIsNotFinite)
{
    const std::string header = ply_header("ascii", "5", "3");
    const std::string body = kSquare + "nan 0 0\n3 0 1 2\n3 0 4 2\n3 0 2 3\n";
    const Scene scene = read(header + body, ".ply");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(warning_of(scene),
        "m.ply: triangles with a corner that is no finite float are left out "
        "(first at triangle 1)");
    // An unused one does not matter.
    const Scene unused =
        read(ply_header("ascii", "5", "1") + kSquare + "nan inf 1e99\n3 0 1 2\n", ".ply");
    EXPECT_TRUE(unused.warnings.empty());
    EXPECT_EQ(unused.triangle_count(), 1u);
    expect_in(error_of<FileError>(
                  ply_header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n", ".ply"),
        "no triangles in it: all 1 have a corner that is no finite float");
}

TEST(Ply, MakesNormalsAndTextureCoordinatesThatAreNotFinite)
{
    const Scene scene = read(ply_header("ascii", "3", "1",
                                 "property float nx\nproperty float ny\nproperty float "
                                 "nz\nproperty float u\nproperty float v\n") +
                                 "0 0 0 nan 0 0 0 0\n1 0 0 1 0 0 inf 0\n0 1 0 1 0 0 1 1\n3 0 1 2\n",
        ".ply");
    const Scene unused = read(
        ply_header("ascii", "4", "1", "property float nx\nproperty float ny\nproperty float nz\n") +
            "0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\nnan nan nan nan nan nan\n3 0 1 2\n",
        ".ply");
    EXPECT_TRUE(unused.warnings.empty());
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.normal[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.uv[1], glm::vec2(0, 0));
    ASSERT_EQ(scene.warnings.size(), 2u);
    expect_in(scene.warnings[0], "normals that are not finite are computed");
    expect_in(scene.warnings[1], "texture coordinates that are not finite are taken as 0");
}

TEST(Ply, ReadsColoursOfVerticesAsLinearLight)
{
    const float half = linear_from_srgb()[128];
    const auto scene = [](const std::string& type, const std::string& rgb,
                           const std::string& prefix) {
        std::string properties;
        for (const char* const channel : {"red", "green", "blue"})
            properties += fmt::format("property {} {}{}\n", type, prefix, channel);
        return read(ply_header("ascii", "3", "1", properties) + "0 0 0 " + rgb + "\n1 0 0 " + rgb +
                        "\n0 1 0 0 0 0\n3 0 1 2\n",
            ".ply");
    };
    for (const char* const prefix : {"", "diffuse_"}) {
        const Scene bytes = scene("uchar", "255 128 0", prefix);
        EXPECT_EQ(color_at(bytes, 0, 0), glm::vec4(1, half, 0, 1));
        EXPECT_EQ(color_at(bytes, 0, 2), glm::vec4(0, 0, 0, 1));
        EXPECT_TRUE(bytes.warnings.empty());
    }
    EXPECT_EQ(color_at(scene("ushort", "65535 32896 0", ""), 0, 0), glm::vec4(1, half, 0, 1));
    EXPECT_EQ(color_at(scene("int", "255 128 -3", ""), 0, 0), glm::vec4(1, half, 0, 1));
    EXPECT_NEAR(color_at(scene("float", "1 0.5 2", ""), 0, 0).y,
        std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-6);
    const Scene odd = scene("float", "1 nan 2", "");
    EXPECT_EQ(color_at(odd, 0, 0), glm::vec4(1));
    expect_in(warning_of(odd), "colours that are not finite are taken as white (2 times)");
}

TEST(Ply, ShowsColoursOnWhite)
{
    const std::string rgba =
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty "
        "uchar alpha\n";
    const Scene scene = read(ply_header("ascii", "3", "1", rgba) +
                                 "0 0 0 255 0 0 51\n1 0 0 255 0 0 51\n0 1 0 255 0 0 51\n3 0 1 2\n",
        ".ply");
    EXPECT_EQ(color_at(scene, 0, 0), glm::vec4(1, 0, 0, 0.2f));
    const Material& material = scene.materials[scene.instances[0].material];
    EXPECT_EQ(std::get<Phong>(material.model).diffuse, glm::vec3(1));
    EXPECT_EQ(material.alpha, AlphaMode::opaque);
}

TEST(Ply, MultipliesColoursOfFacesAndVertices)
{
    const std::string rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const auto made = [&](const std::string& vertex_rgb, const std::string& face) {
        return read(
            ascii(
                "element vertex 4\n" + kXyz + vertex_rgb + "element face 2\n" + rgb + kList, face),
            ".ply");
    };
    const Scene faces = made("", kSquare + "255 0 0 3 0 1 2\n0 0 255 3 0 2 3\n");
    EXPECT_EQ(faces.vertices, 6u);
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(color_at(faces, 0, k), glm::vec4(1, 0, 0, 1));
        EXPECT_EQ(color_at(faces, 1, k), glm::vec4(0, 0, 1, 1));
    }
    const Scene both =
        made(rgb, "0 0 0 255 255 255\n1 0 0 0 0 0\n1 1 0 255 255 255\n0 1 0 255 255 0\n"
                  "255 0 0 3 0 1 2\n0 0 255 3 0 2 3\n");
    EXPECT_EQ(color_at(both, 0, 0), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(color_at(both, 0, 1), glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(color_at(both, 1, 2), glm::vec4(0, 0, 0, 1));
}

/// A picture of one texel.
const std::string kRedPicture = std::string("P6 1 1 255\n") + "\xFF" + std::string(2, '\0');

TEST(Ply, ReadsATextureWithCoordinatesOfFaces)
{
    const TemporaryFolder folder;
    folder.write("skin of a.ppm", kRedPicture);
    const auto text = [](const std::string& file) {
        return "ply\nformat ascii 1.0\ncomment TextureFile " + file + "\nelement vertex 4\n" +
               kXyz + "element face 2\n" + kList +
               "property list uchar float texcoord\nend_header\n" + kSquare +
               "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 0.5 1 0 1\n";
    };
    for (const char* const file :
        {"skin of a.ppm", "C:\\art\\skin of a.ppm", "/art/skin of a.ppm"}) {
        const Scene scene = read_mesh_file(folder.write("a.ply", text(file)), {});
        EXPECT_TRUE(scene.warnings.empty()) << file;
        ASSERT_EQ(scene.textures.size(), 1u) << file;
        EXPECT_EQ(std::get<Phong>(scene.materials[scene.instances[0].material].model).texture, 0);
        EXPECT_EQ(scene.files.size(), 2u);
        EXPECT_EQ(scene.uv[scene.index[0].z], glm::vec2(1, 1));
        EXPECT_EQ(scene.uv[scene.index[1].y], glm::vec2(0.5f, 1));
        EXPECT_EQ(scene.vertices, 5u);
    }
    const Scene missing = read_mesh_file(folder.write("a.ply", text("b.png")), {});
    expect_in(warning_of(missing), "b.png: no such file; a plain colour is used");
}

TEST(Ply, TakesWrongTexcoordListsAsZero)
{
    const Scene scene = read(ascii("element vertex 4\n" + kXyz + "element face 2\n" + kList +
                                       "property list uchar float texcoord\n",
                                 kSquare + "3 0 1 2 0\n4 0 1 2 3 8 0 0 1 0 1 1 0 1\n"),
        ".ply");
    EXPECT_EQ(scene.triangle_count(), 3u);
    EXPECT_EQ(scene.uv[scene.index[0].z], glm::vec2(0, 0));
    EXPECT_EQ(scene.uv[scene.index[2].z], glm::vec2(0, 1));
    expect_in(warning_of(scene), "texture coordinates that are not two a corner are taken as 0");
}

TEST(Ply, ShowsWhatIsThereOfATruncatedFile)
{
    const Scene text = read(ply_header("ascii", "4", "2") + kSquare + "3 0 1 2\n3 0 2\n", ".ply");
    EXPECT_EQ(text.triangle_count(), 1u);
    EXPECT_EQ(warning_of(text), "m.ply: the file ends at face 1 of 2: the rest is missing");
}

TEST(Ply, WarnsOfWhatStandsBehindTheLastElement)
{
    const std::string whole = ply_header("ascii", "4", "1") + kSquare + "3 0 1 2\n";
    expect_in(
        warning_of(read(whole + "3 0 2 3\n", ".ply")), "there are words behind the last element");
    std::string bytes = ply_header("binary_little_endian", "3", "1");
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, x);
    append(bytes, std::uint8_t(3));
    for (const int index : {0, 1, 2}) append(bytes, index);
    EXPECT_TRUE(read(bytes + "\n", ".ply").warnings.empty());
    expect_in(warning_of(read(bytes + "spare", ".ply")), "5 bytes behind the last element");
}

TEST(Ply, SaysThatItIsACloud)
{
    expect_in(error_of<FileError>(ascii("element vertex 4\n" + kXyz, kSquare), ".ply"),
        "m.ply: no triangles in it: it is a cloud of 4 points without faces");
    expect_in(
        error_of<FileError>(ply_header("ascii", "4", "0") + kSquare, ".ply"), "cloud of 4 points");
}

TEST(Ply, ForgivesHeaders)
{
    const auto warning = [](const std::string& elements) {
        return warning_of(read(ascii(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), ".ply"));
    };
    const std::string vertex = "element vertex 3\n" + kXyz, face = "element face 1\n" + kList;
    expect_in(warning("made by hand\n" + vertex + face), "unknown lines of the header are skipped");
    expect_in(warning("element vertex 3 of them\n" + kXyz + face), "spare words in the header");
    EXPECT_TRUE(read("\xEF\xBB\xBF" + ascii("obj_info x = 1\ncomment\n\n" + vertex + face,
                                          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        ".ply")
                    .warnings.empty());
}

TEST(Ply, KeepsBytesBehindAHeaderWithMacintoshLineEnds)
{
    // The first coordinate begins with a byte that is a line feed.
    const std::uint32_t bits = 0x3F80000A;
    float odd = 0;
    std::memcpy(&odd, &bits, sizeof odd);
    std::string bytes = ply_header("binary_little_endian", "3", "1");
    for (char& c : bytes)
        if (c == '\n') c = '\r';
    for (const float x : {odd, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, x);
    append(bytes, std::uint8_t(3));
    for (const int index : {0, 1, 2}) append(bytes, index);
    EXPECT_EQ(corner(read(bytes, ".ply"), 0, 0), glm::vec3(odd, 0, 0));
}

TEST(Ply, KeepsTwoPropertiesOfOneNameApart)
{
    const Scene scene =
        read(ascii("element vertex 3\nproperty int x\n" + kXyz + "element face 1\n" + kList,
                 "5 0 0 0\n6 1 0 0\n7 0 1 0\n3 0 1 2\n"),
            ".ply");
    EXPECT_EQ(corner(scene, 0, 0).x, 5);
    expect_in(
        warning_of(scene), "of properties of the same name the first is used (first at line 5)");
}

} // namespace
} // namespace firsthit::test
