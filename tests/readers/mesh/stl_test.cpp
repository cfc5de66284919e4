// stl_test.cpp - STL files as programs write them: what is shown, what is left out, what is refused.
#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"
#include "base/srgb.h"
#include "scene/model/default_material.h"

#include <fmt/format.h>

namespace firsthit::test {
namespace {

/// One facet of a text, at x.
std::string facet(float x)
{
    return fmt::format(
        "facet normal 0 0 1\nouter loop\nvertex {0} 0 0\nvertex {1} 0 0\nvertex {0} 1 0\n"
        "endloop\nendfacet\n",
        x, x + 1);
}

void set_count(std::string& stl, std::uint32_t count)
{
    std::memcpy(stl.data() + 80, &count, sizeof count);
}

void set_spare(std::string& stl, std::size_t facet_number, std::uint16_t bits)
{
    std::memcpy(stl.data() + 84 + 50 * facet_number + 48, &bits, sizeof bits);
}

TEST(Stl, ReadsWordsWhateverTheLinesAre)
{
    const Scene lines = read("solid s\n" + facet(0) + facet(3) + "endsolid s\n", ".stl");
    for (const char blank : {' ', '\t', '\r'}) {
        std::string text = "solid s\n" + facet(0) + facet(3) + "endsolid s\n";
        for (char& c : text)
            if (c == '\n') c = blank;
        const Scene scene = read(text, ".stl");
        EXPECT_EQ(scene.position, lines.position);
        EXPECT_EQ(scene.index, lines.index);
        EXPECT_TRUE(scene.warnings.empty());
        EXPECT_EQ(scene.instances[0].name, "s");
    }
    EXPECT_EQ(read("\xEF\xBB\xBF \n solid\n" + facet(0) + "endsolid", ".stl").triangle_count(), 1u);
}

TEST(Stl, TextAndBinaryCopiesAreEqualToTheBit)
{
    const Scene binary = read(binary_stl(5), ".stl");
    std::string text = "solid\n";
    for (int f = 0; f < 5; ++f) text += facet(float(f));
    const Scene same = read(text + "endsolid\n", ".stl");
    EXPECT_EQ(same.position, binary.position);
    EXPECT_EQ(same.normal, binary.normal);
    EXPECT_EQ(same.index, binary.index);
}

TEST(Stl, SolidsAreInstances)
{
    const Scene scene = read("solid left side\n" + facet(0) +
                                 "endsolid left side\nsolid empty\nendsolid "
                                 "empty\nsolid right\n" +
                                 facet(1) + facet(2) + "endsolid right\n",
        ".stl");
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].name, "left side");
    EXPECT_EQ(scene.instances[0].triangle_count, 1u);
    EXPECT_EQ(scene.instances[1].name, "right");
    EXPECT_EQ(scene.instances[1].triangle_count, 2u);
    // On one line names end before the next word of the format.
    const Scene line =
        read("solid a facet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet endsolid a solid b "
             "facet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet endsolid b",
            ".stl");
    ASSERT_EQ(line.instances.size(), 2u);
    EXPECT_EQ(line.instances[1].name, "b");
}

TEST(Stl, ForgivesTexts)
{
    const auto warning = [](const std::string& text) {
        const Scene scene = read(text, ".stl");
        EXPECT_EQ(scene.triangle_count(), 1u);
        return warning_of(scene);
    };
    expect_in(warning("solid\n" + facet(0)), "the file ends inside a solid: the rest is missing");
    expect_in(warning("solid\n" + facet(0) + "facet normal 0 0 1\nouter loop\nvertex 1 2"),
        "the file ends inside a solid");
    expect_in(warning("solid\n" + facet(0) + "color 1 0 0\nendsolid\n"),
        "unknown words are left out (first at byte");
    expect_in(
        warning("solid\n" + facet(0) + "facet vertex 0 0 0 vertex 1 0 0 endfacet\nendsolid\n"),
        "faces with fewer than 3 corners are left out (first at triangle 1)");
    expect_in(
        warning(
            "solid\n" + facet(0) +
            "facet normal 1 0 0 outer loop vertex -nan(ind) 0 0 vertex 1 0 0 vertex 1.#QNAN 1 0 "
            "endloop endfacet\nendsolid\n"),
        "triangles with a corner that is no finite float are left out (first at triangle 1)");
    expect_in(warning("; made by hand\n" + ("solid\n" + facet(0)) + "endsolid\n"),
        "unknown words are left out (first at byte");
    const Scene commas =
        read("solid\nfacet outer loop vertex 0,5 0 0 vertex 1,25 0 0 vertex 0 1 0 endloop "
             "endfacet endsolid\n",
            ".stl");
    EXPECT_EQ(corner(commas, 0, 1), glm::vec3(1.25f, 0, 0));
    expect_in(warning_of(commas), "commas in numbers are decimal points (first at byte");
    // A name may have any words.
    EXPECT_TRUE(
        read("solid my solid vertex 1\n" + facet(0) + "endsolid my solid vertex 1\n", ".stl")
            .warnings.empty());
    // Normals are not used, whatever they are.
    EXPECT_TRUE(read(
        "solid\nfacet normal -nan(ind) x 1e999 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 "
        "0 endloop endfacet endsolid\n",
        ".stl")
                    .warnings.empty());
    const Scene quad =
        read("solid\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 "
             "endloop endfacet endsolid\n",
            ".stl");
    EXPECT_EQ(quad.triangle_count(), 2u);
    expect_in(warning_of(quad), "facets of more than 3 corners are cut");
}

TEST(Stl, TakesTheFilesLengthWhereTheCountIsWrong)
{
    for (const std::uint32_t said : {0u, 2u, 4u, 4000000000u}) {
        std::string stl = binary_stl(3);
        set_count(stl, said);
        const Scene scene = read(stl, ".stl");
        EXPECT_EQ(scene.triangle_count(), 3u);
        EXPECT_EQ(warning_of(scene),
            fmt::format("m.stl: the header says {} facets, but the file's length "
                        "makes 3: these are read",
                said));
    }
    // Cut within the third.
    const Scene cut = read(binary_stl(3).substr(0, 84 + 120), ".stl");
    EXPECT_EQ(cut.triangle_count(), 2u);
    ASSERT_EQ(cut.warnings.size(), 2u);
    expect_in(cut.warnings[1], "20 bytes behind the last facet are left out");
}

TEST(Stl, LeavesOutBytesBehindTheFacets)
{
    for (const std::size_t spare : {1u, 20u, 1234u}) {
        const Scene scene = read(binary_stl(3) + std::string(spare, '\1'), ".stl");
        EXPECT_EQ(scene.triangle_count(), 3u);
        EXPECT_EQ(warning_of(scene),
            fmt::format("m.stl: {} bytes behind the last facet are left out", spare));
    }
}

TEST(Stl, ReadsABinaryThatSaysSolidWithAWrongCount)
{
    std::string stl = binary_stl(3);
    stl.replace(0, 12, "solid Object");
    set_count(stl, 7);
    EXPECT_EQ(read(stl, ".stl").triangle_count(), 3u);
}

TEST(Stl, LeavesOutFacetsThatAreNotFinite)
{
    std::string stl = binary_stl(3);
    stl.replace(84 + 50 + 12 + 16, 4, std::string("\x00\x00\x80\x7F", 4));
    const Scene scene = read(stl, ".stl");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 1, 0), glm::vec3(2, 0, 0));
    expect_in(warning_of(scene), "are left out (first at triangle 1)");
}

TEST(Stl, ReadsColoursOfVisCam)
{
    std::string stl = binary_stl(3);
    set_spare(stl, 0, 0x8000 | 31 << 10);     // red
    set_spare(stl, 1, 0x8000 | 16 << 5 | 31); // blue, and half green
    set_spare(stl, 2, 31 << 10);              // none: bit 15 is clear
    const Scene scene = read(stl, ".stl");
    const float grey = std::get<Phong>(default_material().model).diffuse.x;
    EXPECT_EQ(scene.color[scene.index[0].x], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(scene.color[scene.index[1].x], glm::vec4(0, linear_of_srgb(16 / 31.0), 1, 1));
    EXPECT_EQ(scene.color[scene.index[2].x], glm::vec4(grey, grey, grey, 1));
    const Material& material = scene.materials[scene.instances[0].material];
    EXPECT_EQ(std::get<Phong>(material.model).diffuse, glm::vec3(1));
}

TEST(Stl, ReadsColoursOfMagics)
{
    std::string stl = binary_stl(3);
    stl.replace(10, 10, std::string("COLOR=\x00\xFF\x80\xFF", 10));
    set_spare(stl, 0, 31);     // its own: red is in the lowest bits
    set_spare(stl, 1, 0x8000); // that of the header
    set_spare(stl, 2, 31 << 10);
    const Scene scene = read(stl, ".stl");
    const glm::vec4 all(0, 1, linear_from_srgb()[128], 1);
    EXPECT_EQ(scene.color[scene.index[0].x], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(scene.color[scene.index[1].x], all);
    EXPECT_EQ(scene.color[scene.index[2].x], glm::vec4(0, 0, 1, 1));
    // Facets that were not coloured have that of the header too.
    for (std::size_t f = 0; f < 3; ++f) set_spare(stl, f, 0);
    for (const glm::vec4& color : read(stl, ".stl").color) EXPECT_EQ(color, all);
}

TEST(Stl, HasNoColoursWhereBit15IsClear)
{
    std::string stl = binary_stl(3);
    for (std::size_t f = 0; f < 3; ++f) set_spare(stl, f, 0x2020);
    const Scene scene = read(stl, ".stl");
    EXPECT_TRUE(scene.color.empty());
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Stl, ACubeHasFlatSides)
{
    std::string text = "solid cube\n";
    const auto quad = [&](const glm::vec3& o, const glm::vec3& u, const glm::vec3& v) {
        for (const auto& [a, b] : {std::pair{u, u + v}, {u + v, v}}) {
            text += "facet normal 0 0 0 outer loop\n";
            for (const glm::vec3& p : {o, o + a, o + b})
                text += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
            text += "endloop endfacet\n";
        }
    };
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    quad({}, y, x);
    quad(z, x, y);
    quad({}, x, z);
    quad(y, z, x);
    quad({}, z, y);
    quad(x, y, z);
    const Scene scene = read(text + "endsolid\n", ".stl");
    EXPECT_EQ(scene.vertices, 24u);
    for (const glm::uvec3& t : scene.index) {
        const glm::vec3 n = glm::normalize(glm::cross(
            scene.position[t.y] - scene.position[t.x], scene.position[t.z] - scene.position[t.x]));
        for (int k = 0; k < 3; ++k) EXPECT_EQ(scene.normal[t[k]], n);
    }
}

} // namespace
} // namespace firsthit::test
