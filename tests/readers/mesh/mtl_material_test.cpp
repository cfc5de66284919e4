// mtl_material_test.cpp - materials of OBJ files, and what happens without their libraries and textures.
#include "readers/mesh/mesh_text.h"
#include "scene/model/check_scene.h"
#include "scene/model/default_material.h"
#include "temporary_folder.h"

#include <algorithm>

namespace firsthit::test {
namespace {

const std::string kTexturedTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
const std::string kFace = "f 1/1 2/2 3/3\n";

/// A grey picture of 2 x 2 pixels.
std::string picture(const std::string& codes)
{
    return "P5 2 2 255\n" + codes;
}

/// A triangle with the only material of a library, beside which there are pictures.
class MtlScene : public testing::Test {
  protected:
    Scene read(const std::string& mtl, const std::string& rest = "usemtl a\n" + kFace)
    {
        folder_.write("m.mtl", mtl);
        const auto path = folder_.write("a.obj", "mtllib m.mtl\n" + kTexturedTriangle + rest);
        Scene scene = read_mesh_file(path, {});
        check_scene(scene);
        return scene;
    }

    const Material& material(const Scene& scene)
    {
        return scene.materials[scene.instances[0].material];
    }

    TemporaryFolder folder_;
};

TEST_F(MtlScene, IsUsedByTheFacesThatNameIt)
{
    const Scene scene = read("newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n",
        "usemtl green\nf 1 2 3\nusemtl red\nf 3 2 1\n");
    EXPECT_TRUE(scene.warnings.empty());
    const auto diffuse = [&](std::size_t k) {
        return std::get<Phong>(scene.materials[scene.instances[k].material].model).diffuse;
    };
    EXPECT_EQ(diffuse(0), glm::vec3(0, 1, 0));
    EXPECT_EQ(diffuse(1), glm::vec3(1, 0, 0));
}

TEST_F(MtlScene, MissingLibrariesAndMaterialsGiveAWarningAndGrey)
{
    const auto path =
        folder_.write("b.obj", "mtllib none.mtl\nmtllib none.mtl\nmtllib /dev/zero\n" +
                                   kTexturedTriangle + "usemtl green\nf 1 2 3\n");
    const Scene scene = read_mesh_file(path, {});
    ASSERT_EQ(scene.warnings.size(), 3u);
    expect_in(scene.warnings[0], "'none.mtl' is missing");
    expect_in(scene.warnings[1], "'/dev/zero' is missing");
    expect_in(scene.warnings[2], "'green'");
    EXPECT_EQ(material(scene).name, "green");
    EXPECT_EQ(std::get<Phong>(material(scene).model).diffuse,
        std::get<Phong>(default_material().model).diffuse);
}

TEST_F(MtlScene, MissingMaterialsAreWhiteWhereVerticesHaveColours)
{
    const auto path = folder_.write(
        "b.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nusemtl green\nf 1 2 3\n");
    const Scene scene = read_mesh_file(path, {});
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(scene.warnings[0], "the material 'green' is in no library: white");
    EXPECT_EQ(std::get<Phong>(material(scene).model).diffuse, glm::vec3(1));
}

TEST_F(MtlScene, AMissingTextureGivesOneWarningAndAPlainColour)
{
    const Scene scene =
        read("newmtl a\nKd 1 0 0\nmap_Kd none.png\nnewmtl b\nmap_Kd none.png\nmap_d none.png\n",
            "usemtl a\n" + kFace + "usemtl b\n" + kFace);
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(scene.warnings[0], "none.png");
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).texture, -1);
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.materials[1].alpha, AlphaMode::opaque);
}

TEST_F(MtlScene, ALibraryThatCannotBeReadCostsNoMesh)
{
    const Scene scene = read(std::string("\xFF\xFEn\0e\0w\0", 8));
    EXPECT_EQ(scene.triangle_count(), 1u);
    ASSERT_EQ(scene.warnings.size(), 2u);
    expect_in(scene.warnings[0], "m.mtl: the text is UTF-16");
    expect_in(scene.warnings[0], "its materials are left out");
    expect_in(scene.warnings[1], "a.obj: the material 'a' is in no library: grey");
}

TEST_F(MtlScene, FindsNamesInAnyCase)
{
    std::filesystem::create_directory(folder_.path() / "Maps");
    folder_.write("Maps/Grey.PGM", picture("\x80\x80\x80\x80"));
    folder_.write("LIB.MTL", "newmtl a\nmap_Kd maps\\grey.pgm\n");
    const auto path = folder_.write(
        "b.obj", "mtllib C:\\work\\lib.mtl\n" + kTexturedTriangle + "usemtl a\n" + kFace);
    const Scene scene = read_mesh_file(path, {});
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.textures.size(), 1u);
    const std::string picture_file = (folder_.path() / "Maps" / "Grey.PGM").string();
    EXPECT_EQ(std::count(scene.files.begin(), scene.files.end(), picture_file), 1);
}

TEST_F(MtlScene, FaultsOfALibraryAreWarningsThatNameIt)
{
    const Scene scene = read("newmtl a\nKd 1 x 0\n");
    ASSERT_EQ(scene.warnings.size(), 1u);
    expect_in(scene.warnings[0], "m.mtl: values that are no finite number");
}

TEST_F(MtlScene, ScalesAndMovesATexture)
{
    folder_.write("t.pgm", picture("abcd"));
    const Scene scene =
        read("newmtl a\nmap_Kd -s 2 3 1 -o 0.5 0.25 t.pgm\nnewmtl b\nmap_Kd t.pgm\n",
            "usemtl a\n" + kFace + "usemtl b\n" + kFace);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.textures.size(), 1u);
    const auto uv = [&](std::size_t triangle, int k) { return scene.uv[scene.index[triangle][k]]; };
    EXPECT_EQ(uv(0, 0), glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(uv(0, 1), glm::vec2(2.5f, 0.25f));
    EXPECT_EQ(uv(0, 2), glm::vec2(0.5f, 3.25f));
    EXPECT_EQ(uv(1, 1), glm::vec2(1, 0));
}

TEST_F(MtlScene, ClampsATextureOnlyWhereAMaterialSaysSo)
{
    folder_.write("t.pgm", picture("abcd"));
    const Scene scene = read("newmtl a\nmap_Kd -clamp on t.pgm\nnewmtl b\nmap_Kd t.pgm\n",
        "usemtl a\n" + kFace + "usemtl b\n" + kFace);
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[0].sampler().wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.textures[0].sampler().wrap_v, Wrap::clamp);
    EXPECT_EQ(scene.textures[1].sampler().wrap_u, Wrap::repeat);
    EXPECT_EQ(std::get<Phong>(scene.materials[1].model).texture, 1);
}

TEST_F(MtlScene, FindsTheBareNameOfAPathOfAnotherComputer)
{
    folder_.write("t.pgm", picture("abcd"));
    folder_.write(
        "l.mtl", "newmtl a\nmap_Kd C:\\Users\\me\\t.pgm\nnewmtl b\nmap_Kd /home/me/none/t.pgm\n");
    const auto path = folder_.write("b.obj", "mtllib D:\\models\\l.mtl\n" + kTexturedTriangle +
                                                 "usemtl a\n" + kFace + "usemtl b\n" + kFace);
    const Scene scene = read_mesh_file(path, {});
    EXPECT_TRUE(scene.warnings.empty());
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.files.size(), 3u);
}

TEST_F(MtlScene, FindsALibraryWithBlanksAndQuotationMarksInItsName)
{
    folder_.write("my colours.mtl", "newmtl a\nKd 1 0 0\n");
    for (const char* const name :
        {"my colours.mtl", "\"my colours.mtl\"", "C:\\dir\\my colours.mtl"}) {
        const auto path = folder_.write("b.obj",
            "mtllib " + std::string(name) + "\n" + kTexturedTriangle + "usemtl a\n" + kFace);
        EXPECT_TRUE(read_mesh_file(path, {}).warnings.empty()) << name;
    }
}

TEST_F(MtlScene, FindsTheAbsolutePathOfATexture)
{
    const TemporaryFolder elsewhere;
    const std::string path = elsewhere.write("t.pgm", picture("abcd"));
    EXPECT_EQ(read("newmtl a\nmap_Kd " + path + "\n").textures.size(), 1u);
}

TEST_F(MtlScene, BlendsAMaterialThatIsNotOpaque)
{
    const Scene scene = read("newmtl a\nd 0.25\n");
    EXPECT_EQ(material(scene).alpha, AlphaMode::blend);
    EXPECT_EQ(material(scene).opacity, 0.25f);
    const Scene opaque = read("newmtl a\nd 0.9999\n");
    EXPECT_EQ(material(opaque).alpha, AlphaMode::opaque);
    const Scene clear = read("newmtl a\nd 0\n");
    ASSERT_EQ(clear.warnings.size(), 1u);
    expect_in(clear.warnings[0], "invisible (1 of them)");
}

TEST_F(MtlScene, TakesAMapOfOpacityForAMaskOrBlendsIt)
{
    folder_.write("hard.pgm", picture(std::string("\x00\xFF\xFF\x05", 4)));
    folder_.write("soft.pgm", picture(std::string("\x00\x80\xFF\x00", 4)));
    const Scene mask = read("newmtl a\nmap_Kd -s 2 2 hard.pgm\nmap_d hard.pgm\n");
    EXPECT_EQ(material(mask).alpha, AlphaMode::mask);
    EXPECT_EQ(material(mask).opacity, 1);
    const TextureRef& ref = material(mask).opacity_texture;
    ASSERT_GE(ref.texture, 0);
    const Texture& texture = mask.textures[static_cast<std::size_t>(ref.texture)];
    EXPECT_EQ(texture.color(0, 0, 0).a, 0.0f);
    EXPECT_EQ(texture.color(0, 1, 0).a, 1.0f);
    // Texture coordinates have been scaled for the colour, which the opacity undoes.
    EXPECT_EQ(mask.uv[mask.index[0].y], glm::vec2(2, 0));
    EXPECT_EQ(ref.transform * glm::vec3(2, 0, 1), glm::vec2(1, 0));

    const Scene soft = read("newmtl a\nmap_d soft.pgm\n");
    EXPECT_EQ(material(soft).alpha, AlphaMode::blend);
    const Scene both = read("newmtl a\nd 0.5\nmap_d hard.pgm\n");
    EXPECT_EQ(material(both).alpha, AlphaMode::blend);
}

TEST_F(MtlScene, AddsEmissionToAPlainPhongMaterial)
{
    const Scene scene = read("newmtl a\nKa 0.5 0.5 0.5\nKe 0.18 0 0.36\n");
    const Phong& phong = std::get<Phong>(material(scene).model);
    // As Scene::ambient multiplies it, what is sent out is Ke besides the ambient light.
    const glm::vec3 sent = phong.ambient * scene.ambient;
    EXPECT_NEAR(sent.r, 0.5f * kMeshAmbient + 0.18f, 1e-6f);
    EXPECT_NEAR(sent.b, 0.5f * kMeshAmbient + 0.36f, 1e-6f);
}

TEST_F(MtlScene, MakesAllMaterialsPhysicalWhereOneIs)
{
    folder_.write("r.pgm", picture(std::string("\x00\x40\x80\xFF", 4)));
    folder_.write("m.pgm", picture(std::string("\xFF\x00\xFF\x00", 4)));
    folder_.write("n.ppm", "P6 1 1 255\n\x80\x80\xFF");
    const Scene scene =
        read("newmtl a\nKd 1 0.5 0\nPr 0.25\nPm 0.5\nnewmtl b\nNs 30\nKd 0 0 1\n"
             "newmtl c\nmap_Pr r.pgm\nmap_Pm m.pgm\nnorm -bm 2 n.ppm\nmap_Ke m.pgm\n",
            "usemtl a\n" + kFace + "usemtl b\n" + kFace + "usemtl c\n" + kFace + "usemtl none\n" +
                kFace);
    const auto model = [&](std::size_t k) {
        return std::get<MetallicRoughness>(scene.materials[k].model);
    };
    EXPECT_EQ(model(0).base_color, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(model(0).roughness, 0.25f);
    EXPECT_EQ(model(0).metallic, 0.5f);
    EXPECT_EQ(model(1).metallic, 0);
    EXPECT_NEAR(model(1).roughness, 0.5f, 1e-6f); // 2 / 32 is its fourth power
    EXPECT_EQ(model(2).roughness, 1);
    EXPECT_EQ(model(2).metallic, 1);
    EXPECT_EQ(model(2).emission, glm::vec3(1));
    EXPECT_EQ(model(2).normal_scale, 2);
    EXPECT_EQ(scene.materials[3].name, "none");
    EXPECT_EQ(model(3).base_color, std::get<Phong>(default_material().model).diffuse);

    const Texture& packed =
        scene.textures[static_cast<std::size_t>(model(2).metallic_roughness_texture.texture)];
    EXPECT_NEAR(packed.color(0, 1, 0).g, 0x40 / 255.0f, 1e-3f);
    EXPECT_NEAR(packed.color(0, 1, 0).b, 0, 1e-3f);
    EXPECT_NEAR(packed.color(0, 0, 1).g, 0x80 / 255.0f, 1e-3f);
    EXPECT_NEAR(packed.color(0, 0, 1).b, 1, 1e-3f);
    ASSERT_EQ(scene.tangent.size(), scene.vertices);
    EXPECT_EQ(scene.tangent[scene.index[2].x], glm::vec4(1, 0, 0, 1));
}

} // namespace
} // namespace firsthit::test
