// mtl_test.cpp - materials of OBJ files, and what happens without their libraries and textures.
#include "readers/mesh/mtl.h"
#include "scene/model/default_material.h"

#include "message_of.h"
#include "readers/mesh/mesh_text.h"
#include "scene/model/default_material.h"
#include "temporary_folder.h"

namespace firsthit::test {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";

TEST(Mtl, ReadsPhongsNumbers)
{
    const auto materials = read_mtl("# two\nnewmtl red one\r\nKa 0.1 0.2 0.3\nKd 0.9 0.1 0.1\n"
                                    "Ks 0.5\nNs 42\nNi 1.5\nd 0.75\nillum 2\n"
                                    "map_Kd -s 1 1 1 -clamp on some\\dir\\wood 2.png\n"
                                    "newmtl b\nTr 0.25\nd -halo 0.5\nmap_Kd 7\n",
        "m.mtl");
    ASSERT_EQ(materials.size(), 2u);
    const Phong& red = materials[0].material;
    EXPECT_EQ(materials[0].name, "red one");
    EXPECT_EQ(red.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(red.diffuse, glm::vec3(0.9f, 0.1f, 0.1f));
    EXPECT_EQ(red.specular, glm::vec3(0.5f));
    EXPECT_EQ(red.shininess, 42.0f);
    EXPECT_EQ(red.ior, 1.5f);
    EXPECT_EQ(red.transmittance, 0.25f);
    EXPECT_EQ(materials[0].texture, "some/dir/wood 2.png");
    EXPECT_EQ(materials[1].material.transmittance, 0.5f);
    EXPECT_EQ(materials[1].texture, "7");
}

TEST(Mtl, TakesTheDiffuseColourForAnAmbientOneThatIsMissing)
{
    const auto materials = read_mtl("newmtl a\nKd 1 0 0\nnewmtl b\nKa 0 0 1\nKd 1 0 0\n", "m.mtl");
    EXPECT_EQ(materials[0].material.ambient, glm::vec3(1, 0, 0));
    EXPECT_EQ(materials[1].material.ambient, glm::vec3(0, 0, 1));
}

TEST(Mtl, NamesTheLineOfAnError)
{
    const auto message = [](const char* text) {
        return message_of<Error>([&] { read_mtl(text, "m.mtl"); });
    };
    expect_in(message("Kd 1 1 1\n"), "m.mtl:1: Kd stands before any newmtl");
    expect_in(message("newmtl a\nKd 1 x 1\n"), "m.mtl:2: green is 'x'");
    expect_in(message("newmtl a\nKd 1 nan 1\n"), "m.mtl:2: green is nan");
    expect_in(message("newmtl a\nNs\n"), "m.mtl:2: the line ends before Ns");
}

TEST(Mtl, IsUsedByTheFacesThatNameIt)
{
    const TemporaryFolder folder;
    folder.write("my colours.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n");
    const auto path = folder.write("a.obj",
        "mtllib my colours.mtl\n" + kTriangle + "usemtl green\nf 1 2 3\nusemtl red\nf 3 2 1\n");
    const Scene scene = read_mesh_file(path, {});
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(std::get<Phong>(scene.materials[scene.parts[0].material].model).diffuse,
        glm::vec3(0, 1, 0));
    EXPECT_EQ(std::get<Phong>(scene.materials[scene.parts[1].material].model).diffuse,
        glm::vec3(1, 0, 0));
}

TEST(Mtl, MissingLibrariesAndMaterialsGiveAWarningAndGrey)
{
    const TemporaryFolder folder;
    const auto path = folder.write("a.obj", "mtllib none.mtl\nmtllib none.mtl\nmtllib /dev/zero\n" +
                                                kTriangle + "usemtl green\nf 1 2 3\n");
    const Scene scene = read_mesh_file(path, {});
    ASSERT_EQ(scene.warnings.size(), 3u);
    expect_in(scene.warnings[0], "'none.mtl' is missing");
    expect_in(scene.warnings[1], "'/dev/zero' is missing");
    expect_in(scene.warnings[2], "'green'");
    const Material& material = scene.materials[scene.parts[0].material];
    EXPECT_EQ(material.name, "green");
    EXPECT_EQ(
        std::get<Phong>(material.model).diffuse, std::get<Phong>(default_material().model).diffuse);
}

TEST(Mtl, AMissingTextureGivesOneWarningAndAPlainColour)
{
    const TemporaryFolder folder;
    folder.write("a.mtl", "newmtl a\nKd 1 0 0\nmap_Kd none.png\nnewmtl b\nmap_Kd none.png\n");
    const auto path = folder.write("a.obj",
        "mtllib a.mtl\n" + kTriangle + "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n");
    const Scene scene = read_mesh_file(path, {});
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(scene.warnings[0], "none.png");
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).texture, -1);
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).diffuse, glm::vec3(1, 0, 0));
}

} // namespace
} // namespace firsthit::test
