// mtl_test.cpp - the statements of material libraries.
#include "readers/mesh/mtl/mtl.h"

#include "message_of.h"
#include "readers/mesh/mesh_text.h"

namespace firsthit::test {
namespace {

/// Reads a library that must have no fault.
std::vector<MtlMaterial> read_sound(const std::string& text)
{
    Problems problems;
    std::vector<MtlMaterial> materials = read_mtl(text, "m.mtl", problems);
    EXPECT_TRUE(problems.empty()) << problems.lines("m.mtl")[0];
    return materials;
}

/// The only material of a library with one kind of fault.
MtlMaterial read_faulty(const std::string& text, const std::string& warning)
{
    Problems problems;
    std::vector<MtlMaterial> materials = read_mtl(text, "m.mtl", problems);
    EXPECT_EQ(problems.lines("m.mtl").size(), 1u) << text;
    if (!problems.empty()) expect_in(problems.lines("m.mtl")[0], warning);
    EXPECT_EQ(materials.size(), 1u);
    return materials.at(0);
}

MtlMap map_of(const std::string& words)
{
    return read_sound("newmtl a\nmap_Kd " + words + "\n")[0].diffuse_map;
}

TEST(Mtl, ReadsPhongsNumbers)
{
    const auto materials = read_sound("# two\nnewmtl red one\r\nKa 0.1 0.2 0.3\nKd 0.9 0.1 0.1\n"
                                      "Ks 0.5\nNs 42\nNi 1.5\nd 0.75\nillum 2\n"
                                      "map_Kd -s 1 1 1 -clamp on some\\dir\\wood 2.png\n"
                                      "newmtl b\nTr 0.25\nd -halo 0.5\nmap_Kd 7\n");
    ASSERT_EQ(materials.size(), 2u);
    const Phong& red = materials[0].phong;
    EXPECT_EQ(materials[0].name, "red one");
    EXPECT_EQ(red.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(red.diffuse, glm::vec3(0.9f, 0.1f, 0.1f));
    EXPECT_EQ(red.specular, glm::vec3(0.5f));
    EXPECT_EQ(red.shininess, 42.0f);
    EXPECT_EQ(red.ior, 1.5f);
    EXPECT_EQ(materials[0].opacity, 0.75f);
    EXPECT_EQ(materials[0].diffuse_map.file, "some/dir/wood 2.png");
    EXPECT_EQ(materials[1].opacity, 0.5f);
    EXPECT_EQ(materials[1].diffuse_map.file, "7");
}

TEST(Mtl, TakesTheDiffuseColourForAnAmbientOneThatIsMissing)
{
    const auto materials = read_sound("newmtl a\nKd 1 0 0\nnewmtl b\nKa 0 0 1\nKd 1 0 0\n");
    EXPECT_EQ(materials[0].phong.ambient, glm::vec3(1, 0, 0));
    EXPECT_EQ(materials[1].phong.ambient, glm::vec3(0, 0, 1));
}

TEST(Mtl, ReadsOpacityFromDThenFromTr)
{
    const auto opacity = [](const std::string& lines) {
        return read_sound("newmtl a\n" + lines + "newmtl b\n")[0].opacity;
    };
    EXPECT_EQ(opacity("d 0.25\n"), 0.25f);
    EXPECT_EQ(opacity("Tr 0.25\n"), 0.75f);
    EXPECT_EQ(opacity("Tr 0.25\nd 0.5\n"), 0.5f);
    EXPECT_EQ(opacity("d 0.5\nTr 0.25\n"), 0.5f);
    EXPECT_EQ(opacity("d 0\n"), 0.0f);
    EXPECT_EQ(opacity("d 1.5\n"), 1.0f);
    EXPECT_EQ(opacity("d 1\nTr 1\n"), 1.0f);
    EXPECT_EQ(opacity(""), 1.0f);
    EXPECT_EQ(read_faulty("newmtl a\nTr 1\n", "Tr 1 without").opacity, 1.0f);
}

TEST(Mtl, ReadsTheExtensionForPhysicallyBasedShading)
{
    const MtlMaterial a = read_sound("newmtl a\nPr 0.25\nPm 1\nPs 0.1\nKe 1 2 3\nmap_Pr r.png\n"
                                     "map_Pm -s 2 2 m.png\nmap_Ke e.png\nnorm -bm 0.5 n.png\n")[0];
    EXPECT_EQ(a.roughness, 0.25f);
    EXPECT_EQ(a.metallic, 1.0f);
    EXPECT_EQ(a.emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(a.roughness_map.file, "r.png");
    EXPECT_EQ(a.metallic_map.scale, glm::vec2(2));
    EXPECT_EQ(a.emission_map.file, "e.png");
    EXPECT_EQ(a.normal_map.file, "n.png");
    EXPECT_EQ(a.normal_map.strength, 0.5f);
    EXPECT_TRUE(a.is_physical());
    EXPECT_FALSE(
        read_sound("newmtl a\nKd 1 1 1\nKe 1 1 1\nmap_Ka b.png\nd 0.5\n")[0].is_physical());
    EXPECT_FALSE(read_sound("newmtl a\nKe 0 0 0\nmap_Kd b.png\n")[0].is_physical());
    EXPECT_TRUE(read_sound("newmtl a\nKe 1 0 0\nmap_Kd b.png\n")[0].is_physical());
}

TEST(Mtl, ReadsOptionsBeforeAndBehindAName)
{
    const MtlMap before = map_of("-blendu on -s 2 3 1 -o 0.25 -0.5 0 -clamp on -imfchan m a b.png");
    EXPECT_EQ(before.file, "a b.png");
    EXPECT_EQ(before.scale, glm::vec2(2, 3));
    EXPECT_EQ(before.offset, glm::vec2(0.25f, -0.5f));
    EXPECT_TRUE(before.clamp);
    EXPECT_EQ(before.channel, 'm');
    const MtlMap behind = map_of("a b.png -clamp off -s 2 3 1 -o 0.25");
    EXPECT_EQ(behind.file, "a b.png");
    EXPECT_EQ(behind.scale, glm::vec2(2, 3));
    EXPECT_EQ(behind.offset, glm::vec2(0.25f, 0));
    EXPECT_FALSE(behind.clamp);
    EXPECT_EQ(map_of("-s 2 3 1 4").file, "4"); // a number where there must be a name
    EXPECT_EQ(map_of("-s 2 2.png").file, "2.png");
    EXPECT_EQ(map_of("-s 2 2.png").scale, glm::vec2(2));
    EXPECT_EQ(map_of("-texres 512 -colorspace sRGB -mm 0 1 a.png").file, "a.png");
    EXPECT_EQ(map_of("-new 1 on a.png").file, "a.png");
    EXPECT_EQ(map_of("\"C:\\my files\\a.png\"").file, "C:/my files/a.png");
    EXPECT_EQ(map_of("wood-oak - 2.png").file, "wood-oak - 2.png");
    EXPECT_EQ(map_of("").file, "");
}

TEST(Mtl, LeavesOutWhatIsNoFiniteNumber)
{
    const std::string kind = "values that are no finite number are left out (first at line 2";
    EXPECT_EQ(read_faulty("newmtl a\nKd 1 x 1\n", kind).phong.diffuse, Phong().diffuse);
    EXPECT_EQ(
        read_faulty("newmtl a\nKd 1 nan 1\nKd 0 0 1\n", kind).phong.diffuse, glm::vec3(0, 0, 1));
    EXPECT_EQ(read_faulty("newmtl a\nNs\n", kind).phong.shininess, 1.0f);
    EXPECT_EQ(read_faulty("newmtl a\nNs inf\nNs 1e99\n", "2 times").phong.shininess, 1.0f);
    EXPECT_EQ(read_faulty("newmtl a\nd 1.#QNAN\n", kind).opacity, 1.0f);
    EXPECT_FALSE(read_faulty("newmtl a\nPr rough\n", kind).roughness);
    EXPECT_EQ(
        read_faulty("newmtl a\nmap_Kd -s nan 1 a.png\n", "options whose numbers").diffuse_map.scale,
        glm::vec2(1));
}

TEST(Mtl, ReadsCommasInNumbers)
{
    for (const char* const line : {"Kd 0,5 0,25 1", "Kd 0.5, 0.25, 1"})
        EXPECT_EQ(
            read_faulty("newmtl a\n" + std::string(line) + "\n", "commas in numbers").phong.diffuse,
            glm::vec3(0.5f, 0.25f, 1));
}

TEST(Mtl, TellsOfUnknownStatementsAndOfPicturesThatAreNotShown)
{
    read_faulty("newmtl a\nfoo 1\nFoo 2\n",
        "m.mtl: unknown statements 'foo' are left out (first at line 2, 2 times)");
    read_faulty("newmtl a\nmap_Bump -bm 1 b.png\n",
        "m.mtl: pictures of 'map_bump' are not shown (first at line 2)");
    read_sound("newmtl a\nillum 2\nTf 1 1 1\nsharpness 60\nmap_Ka a.png\nPs 0\naniso 0\n");
    Problems problems;
    std::string text = "newmtl a\n";
    for (int k = 0; k < 100; ++k) text += "x" + std::to_string(k) + " 1\n";
    read_mtl(text, "m.mtl", problems);
    ASSERT_EQ(problems.lines("m.mtl").size(), 9u);
    expect_in(
        problems.lines("m.mtl")[8], "other unknown statements are left out (first at line 10, 92");
}

TEST(Mtl, LeavesOutWhatStandsBeforeTheFirstMaterial)
{
    read_faulty("Kd 1 1 1\nNs 1\nnewmtl a\n",
        "before the first newmtl are left out (first at line 1, 2 times)");
}

TEST(Mtl, ReadsEveryLineEndAndByteOrderMarkAndCase)
{
    for (const char* const end : {"\n", "\r\n", "\r"}) {
        const std::string e = end;
        const auto materials =
            read_sound("\xEF\xBB\xBFnewmtl a" + e + "\tkd 1 0 0 # red" + e + "  MAP_KD t.png" + e);
        ASSERT_EQ(materials.size(), 1u);
        EXPECT_EQ(materials[0].name, "a");
        EXPECT_EQ(materials[0].phong.diffuse, glm::vec3(1, 0, 0));
        EXPECT_EQ(materials[0].diffuse_map.file, "t.png");
    }
    Problems problems;
    expect_in(
        message_of<FileError>([&] { read_mtl(std::string("\xFF\xFEn\0", 4), "m.mtl", problems); }),
        "m.mtl: the text is UTF-16");
}

} // namespace
} // namespace firsthit::test
