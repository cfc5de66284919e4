// read_assimp_test.cpp - COLLADA files become the scenes they describe, and what is wrong is said.
#include "message_of.h"
#include "readers/assimp/dae_numbers.h"
#include "readers/assimp/dae_text.h"
#include "readers/assimp/read_assimp.h"
#include "scene/model/check_scene.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace firsthit::test {
namespace {

#ifdef FIRSTHIT_WITH_ASSIMP

Scene read(const std::string& text, const std::filesystem::path& folder = {})
{
    Scene scene = read_assimp("m.dae", text, ".dae", folder, {});
    check_scene(scene);
    return scene;
}

/// Smallest and largest coordinates at a time.
std::array<glm::vec3, 2> box_at(Scene scene, double time_s)
{
    World world;
    pose(std::move(scene), time_s, world);
    return bounds(world);
}

void expect_near(const glm::vec3& a, const glm::vec3& b)
{
    EXPECT_LT(glm::distance(a, b), 1e-5f * (1 + glm::length(b)))
        << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(Assimp, ReadsAPolygonBelowItsNode)
{
    const Scene scene = read(dae({}));
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(scene.vertices, 4u);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.nodes[scene.instances[0].node].name, "arm");
    const auto [low, high] = box_at(scene, 0);
    expect_near(low, {0, 0, 3});
    expect_near(high, {2, 1, 3});
}

TEST(Assimp, LengthsBecomeMetresAndTheFilesAxisPointsUp)
{
    const auto inches = box_at(read(dae({.unit = "0.0254"})), 0);
    expect_near(inches[1], {0.0508f, 0.0254f, 0.0762f});
    // z of the file is y, y of the file goes backwards.
    const auto z_up = box_at(read(dae({.up = "Z_UP"})), 0);
    expect_near(z_up[0], {0, 3, -1});
    expect_near(z_up[1], {2, 3, 0});
}

TEST(Assimp, PhongMaterialsAreTakenAsTheyAre)
{
    const Scene scene =
        read(dae({.effect = "<phong><diffuse><color>0.5 0.25 0.125 1</color></diffuse>"
                            "<specular><color>0.75 0.5 0.25 1</color></specular>"
                            "<shininess><float>20</float></shininess></phong>"}));
    const Material& material = scene.materials[scene.instances[0].material];
    EXPECT_EQ(material.name, "paint");
    EXPECT_EQ(material.alpha, AlphaMode::opaque);
    const auto& phong = std::get<Phong>(material.model);
    EXPECT_EQ(phong.diffuse, glm::vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(phong.specular, glm::vec3(0.75f, 0.5f, 0.25f));
    EXPECT_EQ(phong.shininess, 20);
}

TEST(Assimp, ChannelsMoveNodes)
{
    const Scene scene = read(dae({.libraries = R"(<library_animations><animation id="a">
<source id="a-t"><float_array id="a-ta" count="2">1 3</float_array><technique_common>
<accessor source="#a-ta" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="a-v"><float_array id="a-va" count="2">0 8</float_array><technique_common>
<accessor source="#a-va" count="2" stride="1"><param name="X" type="float"/></accessor></technique_common></source>
<source id="a-i"><Name_array id="a-ia" count="2">LINEAR LINEAR</Name_array><technique_common>
<accessor source="#a-ia" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor></technique_common></source>
<sampler id="a-s"><input semantic="INPUT" source="#a-t"/><input semantic="OUTPUT" source="#a-v"/>
<input semantic="INTERPOLATION" source="#a-i"/></sampler><channel source="#a-s" target="arm/move.X"/>
</animation></library_animations>)"}));
    ASSERT_EQ(scene.clips.size(), 1u);
    EXPECT_NEAR(scene.begin_s(), 1, 1e-6);
    EXPECT_NEAR(scene.end_s(), 3, 1e-6);
    expect_near(box_at(scene, 1)[0], {0, 0, 3});
    expect_near(box_at(scene, 1.5)[0], {2, 0, 3});
    expect_near(box_at(scene, 2.75)[1], {9, 1, 3});
    expect_near(box_at(scene, 9)[1], {10, 1, 3});
}

TEST(Assimp, CamerasHaveVerticalAngles)
{
    const Scene scene = read(
        dae({.libraries = R"(<library_cameras><camera id="c" name="c"><optics><technique_common>
<perspective><yfov>30</yfov><aspect_ratio>2</aspect_ratio><znear>1</znear><zfar>9</zfar></perspective>
</technique_common></optics></camera><camera id="flat" name="flat"><optics><technique_common><orthographic>
<xmag>3</xmag><aspect_ratio>1</aspect_ratio><znear>1</znear><zfar>9</zfar></orthographic></technique_common></optics>
</camera></library_cameras>)",
            .nodes = "<node id=\"eye\" name=\"eye\"><translate>1 2 9</translate>"
                     "<instance_camera url=\"#c\"/></node>"}));
    ASSERT_EQ(scene.cameras.size(), 1u);
    World world;
    pose(Scene(scene), 0, world);
    EXPECT_NEAR(world.camera.fov_y_rad, 30 * 3.14159265 / 180, 1e-4);
    expect_near(glm::vec3(world.camera.eye), {1, 2, 9});
    expect_near(glm::vec3(glm::normalize(world.camera.direction)), {0, 0, -1});
}

TEST(Assimp, TheBrightestLightIsWhiteAndRatiosStay)
{
    const auto light = [](const char* id, double value) {
        return fmt::format("<light id=\"{0}\" name=\"{0}\"><technique_common><point><color>{1} {1} "
                           "0</color></point></technique_common></light>",
            id, value);
    };
    const auto node = [](const char* id, double x) {
        return fmt::format("<node id=\"n{0}\" name=\"n{0}\"><translate>{1} 0 0</translate>"
                           "<instance_light url=\"#{0}\"/></node>",
            id, x);
    };
    const Scene scene = read(dae(
        {.libraries = "<library_lights>" + light("a", 50) + light("b", 200) + "</library_lights>",
            .nodes = node("a", 5) + node("b", 7)}));
    ASSERT_EQ(scene.lights.size(), 2u);
    World world;
    pose(Scene(scene), 0, world);
    expect_near(world.lights[0].color, {0.25f, 0.25f, 0});
    expect_near(world.lights[1].color, {1, 1, 0});
    expect_near(glm::vec3(world.lights[1].position), {7, 0, 0});
}

TEST(Assimp, BonesMoveTheirVerticesAndTheNodeMovesTheRest)
{
    // The joint has moved by (0, 0, 5) since the skin was bound; vertices 1 and 2 follow it, 1 by half.
    const Scene scene =
        read(dae({.libraries = R"(<library_controllers><controller id="k"><skin source="#quad">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="k-j"><Name_array id="k-ja" count="2">base tip</Name_array><technique_common>
<accessor source="#k-ja" count="2" stride="1"><param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="k-b"><float_array id="k-ba" count="32">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1
1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array><technique_common><accessor source="#k-ba" count="2" stride="16">
<param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>
<source id="k-w"><float_array id="k-wa" count="2">1 0.5</float_array><technique_common>
<accessor source="#k-wa" count="2" stride="1"><param name="WEIGHT" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#k-j"/><input semantic="INV_BIND_MATRIX" source="#k-b"/></joints>
<vertex_weights count="4"><input semantic="JOINT" source="#k-j" offset="0"/>
<input semantic="WEIGHT" source="#k-w" offset="1"/><vcount>1 2 1 1</vcount>
<v>0 0 0 1 1 1 1 0 0 0</v></vertex_weights></skin></controller></library_controllers>)",
            .nodes = R"(<node id="base" name="base" sid="base" type="JOINT">
<node id="tip" name="tip" sid="tip" type="JOINT"><translate>0 0 5</translate></node></node>
<node id="body" name="body"><instance_controller url="#k"><skeleton>#base</skeleton></instance_controller></node>)"}));
    ASSERT_EQ(scene.skins.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    const Instance& skinned = scene.instances[scene.instances[0].skin >= 0 ? 0 : 1];
    World world;
    pose(Scene(scene), 0, world);
    // By the place of the vertex in x and y, which stay.
    for (std::size_t v = skinned.first_vertex; v < skinned.first_vertex + skinned.vertex_count;
         ++v) {
        const glm::vec3& p = world.position[v];
        EXPECT_NEAR(p.z, p.x < 1 ? 0 : p.y < 0.5 ? 2.5 : 5, 1e-5) << p.x << " " << p.y;
    }
}

TEST(Assimp, TexturesLieBesideTheFileUnderTheirBareNamesToo)
{
    const TemporaryFolder folder;
    folder.write("red.ppm", std::string("P6\n1 1\n255\n\xFF") + std::string(2, '\0'));
    const Scene scene = read(
        dae({.effect =
                 R"(<newparam sid="s"><surface type="2D"><init_from>img</init_from></surface></newparam>)",
            .images =
                R"(<library_images><image id="img"><init_from>file:///C:/work/red.ppm</init_from></image>)"
                R"(</library_images>)"}),
        folder.path());
    EXPECT_TRUE(scene.textures.empty()); // no one asks for it
    const Scene used = read(
        dae({.effect =
                 "<phong><diffuse><texture texture=\"img\" texcoord=\"uv\"/></diffuse></phong>",
            .images =
                R"(<library_images><image id="img"><init_from>C:\work\red.ppm</init_from></image>)"
                R"(</library_images>)"}),
        folder.path());
    ASSERT_EQ(used.textures.size(), 1u);
    EXPECT_EQ(used.textures[0].color(0, 0, 0), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(used.files, (std::vector<std::string>{folder / "red.ppm"}));
}

TEST(Assimp, ReadsColladaInTwoBytesALetter)
{
    const std::string text = dae({});
    std::string little = "\xFF\xFE", big = "\xFE\xFF";
    for (const char c : text) {
        little += {c, '\0'};
        big += {'\0', c};
    }
    EXPECT_EQ(read(little).triangle_count(), 2u);
    EXPECT_EQ(read(big).triangle_count(), 2u);
}

TEST(Assimp, ReadsColladaNumbersBehindBlanks)
{
    EXPECT_EQ(without_blanks_before_numbers("<a> \n 1 2 </a>\n <b> x 1</b> <c>\t-.5</c> "),
        "<a>1 2 </a>\n <b> x 1</b> <c>-.5</c> ");
    EXPECT_EQ(without_blanks_before_numbers(""), "");
    EXPECT_EQ(without_blanks_before_numbers("no tag 1"), "no tag 1");
    EXPECT_EQ(without_blanks_before_numbers("<a> "), "<a> ");
    const std::string text = dae({});
    std::string spaced = text;
    for (std::size_t at = spaced.find("<color"); at != spaced.npos;
         at = spaced.find("<color", at + 1))
        spaced.insert(spaced.find('>', at) + 1, "\n  ");
    ASSERT_NE(spaced, text);
    EXPECT_EQ(read(spaced).materials[0].name, read(text).materials[0].name);
}

TEST(Assimp, SaysWhatIsWrong)
{
    EXPECT_EQ(message_of<FileError>([] { read(""); }), "m.dae: the file is empty");
    EXPECT_EQ(message_of<FileError>([] { read_assimp("m.3mf", "PK", ".3mf", {}, {}); }),
        "m.3mf: cannot be read: Failed to open file *.3mf.");
    EXPECT_NE(message_of<FileError>([] { read("<COLLADA"); }).find("m.dae: cannot be read: "),
        std::string::npos);
    EXPECT_THROW(read(dae({.faces = "0 1 2 99"})), Error);
    EXPECT_THROW(read(dae({.positions = "0 0 0 nan 0 0 2 1 0 0 1 0"})), Error);
    // The ending counts, not what is in the file.
    EXPECT_THROW(read_assimp("m.fbx", dae({}), ".fbx", {}, {}), FileError);
    EXPECT_THROW(
        read_assimp("m.fbx", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ".fbx", {}, {}), FileError);
}

#else

TEST(Assimp, SaysWhatToInstallWhereItIsMissing)
{
    EXPECT_EQ(message_of<FileError>([] { read_assimp("m.dae", dae({}), ".dae", {}, {}); }),
        "m.dae: .dae files need the library Assimp, which was not there when firsthit was built: "
        "apt-get install libassimp-dev, and build again");
}

#endif

} // namespace
} // namespace firsthit::test
