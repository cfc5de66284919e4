// load_scene_test.cpp - names become scenes: files by their ending, built-ins, and arrays.
#include "scene/model/check_scene.h"

#include "message_of.h"
#include "readers/mesh/mesh_text.h"
#include "temporary_folder.h"

#include <glm/geometric.hpp>

namespace firsthit::test {
namespace {

template <class Kind>
std::string load_error(const std::string& name)
{
    return message_of<Kind>([&] { load_scene(name); });
}

TEST(LoadScene, KnowsAFileByItsEndingInAnyCase)
{
    const TemporaryFolder folder;
    EXPECT_EQ(load_scene(folder.write("A.OBJ", kCubeObj).string()).triangle_count(), 12u);
    EXPECT_EQ(load_scene(folder.write("b.Stl", binary_stl(2)).string()).triangle_count(), 2u);
}

TEST(LoadScene, ListsWhatIsAcceptedForAnUnknownEnding)
{
    for (const char* const name : {"a.blend", "noending", "a.ply.gz", ""})
        expect_in(load_error<FileError>(name), ".aff, .nff, .ply, .stl, .obj");
}

TEST(LoadScene, SaysThatAFileIsMissing)
{
    for (const char* const name : {"no.ply", "no.stl", "no.obj"})
        expect_in(load_error<FileError>(name), "no such file");
}

TEST(LoadScene, ListsTheBuiltinsForAnUnknownOne)
{
    expect_in(load_error<ArgumentError>("builtin:teapot"),
        "builtin:torus, builtin:robots, builtin:room, builtin:wave?n=N");
    expect_in(load_error<ArgumentError>("builtin:torus?n=3"), "takes no parameters");
}

TEST(LoadScene, SaysWhatAWaveAccepts)
{
    for (const char* const parameters : {"n=1", "n=10000001", "n=", "n=x", "n=2.5", "m=4", "n", "",
             "n=-5", "n=99999999999999999999", "n=4&n=5"})
        expect_in(load_error<ArgumentError>(std::string("builtin:wave?") + parameters),
            "accepted is n=N, N triangles from 2 to 10000000");
    EXPECT_NO_THROW(load_scene("builtin:wave"));
}

/// What load_scene says a scene was read from, without the folder.
std::vector<std::string> files_of(const TemporaryFolder& folder, const std::string& name)
{
    std::vector<std::string> files = load_scene(folder / name).files;
    for (std::string& file : files)
        file = std::filesystem::path(file).lexically_relative(folder.path()).generic_string();
    return files;
}

using Files = std::vector<std::string>;

const std::string kPixel = std::string("P6 1 1 255\n") + "\x10\x20\x30";

TEST(LoadSceneFiles, AreTheMeshFile)
{
    const TemporaryFolder folder;
    folder.write("a.obj", kCubeObj);
    folder.write("b.stl", binary_stl(2));
    folder.write("c.ply", ply_header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (const char* const name : {"a.obj", "b.stl", "c.ply"})
        EXPECT_EQ(files_of(folder, name), Files{name});
}

TEST(LoadSceneFiles, AreLibrariesAndTexturesOfAnObjFile)
{
    const TemporaryFolder folder;
    folder.write("a.obj", "mtllib sub/a.mtl gone.mtl\nmtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                          "vt 0 0\nusemtl one\nf 1/1 2/1 3/1\nusemtl two\nf 3/1 2/1 1/1\n"
                          "usemtl three\nf 1/1 3/1 2/1\nusemtl four\nf 2/1 3/1 1/1\n");
    folder.write("sub/a.mtl", "newmtl one\nmap_Kd one.ppm\nnewmtl two\nmap_Kd ../bad.png\n");
    folder.write("b.mtl", "newmtl three\nmap_Kd gone.png\nnewmtl four\nmap_Kd sub/one.ppm\n");
    folder.write("sub/one.ppm", kPixel);
    folder.write("bad.png", "no picture");
    folder.write("unused.png", "never read");
    EXPECT_EQ(files_of(folder, "a.obj"),
        (Files{"a.obj", "sub/a.mtl", "b.mtl", "sub/one.ppm", "sub/../bad.png"}));
}

TEST(LoadSceneFiles, AreIncludesAndTexturesOfAnAffFile)
{
    const TemporaryFolder folder;
    const std::string corners = " 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\n";
    folder.write("aff/main.aff", "i 0 parts/a.aff\ni 5 detail.aff\ni 0 parts/a.aff\ntt one.ppm" +
                                     corners + "tt gone.ppm" + corners + "tt bad.ppm" + corners);
    folder.write("aff/parts/a.aff", "i 0 b.aff\ntt far.ppm" + corners);
    folder.write("aff/b.aff", "p 3  0 0 0  1 0 0  0 1 0\n");
    folder.write("aff/detail.aff", "p 3  0 0 0  1 0 0  0 1 0\n");
    folder.write("aff/one.ppm", kPixel);
    folder.write("aff/bad.ppm", "no picture");
    folder.write("TextureFiles/far.ppm", kPixel);
    EXPECT_EQ(files_of(folder, "aff/main.aff"),
        (Files{"aff/main.aff", "aff/parts/a.aff", "aff/b.aff", "aff/../TextureFiles/far.ppm",
            "aff/one.ppm", "aff/bad.ppm"}));
}

TEST(LoadSceneFiles, AreNoneOfABuiltin)
{
    EXPECT_TRUE(load_scene("builtin:torus").files.empty());
    EXPECT_TRUE(load_scene("builtin:robots").files.empty());
}

TEST(LoadScene, LightsAFileWithoutLightsFromTheCamera)
{
    const TemporaryFolder folder;
    World world;
    pose(load_scene(folder.write("a.obj", kCubeObj).string()), 0, world);
    ASSERT_EQ(world.lights.size(), 1u);
    EXPECT_TRUE(world.lights[0].on_camera);
    for (const glm::dvec3 direction :
        {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 7)}) {
        const Camera camera{.eye = {1, 2, 3}, .direction = direction, .up = {0, 1, 0}};
        hang_lights(camera, world);
        const glm::dvec3 shines = world.lights[0].direction;
        EXPECT_GT(glm::dot(shines, direction), 0);                        // away from the viewer
        EXPECT_GT(glm::dot(shines, glm::cross(direction, camera.up)), 0); // to the right
        EXPECT_LT(shines.y, 0);                                           // down
    }
}

TEST(SceneFromArrays, MakesFlatNormalsWhereItIsGivenNone)
{
    const Scene scene = scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{0, 1, 2}, {0, 2, 3}}, {}, {{0, 0}, {1, 0}, {0, 1}, {1, 1}});
    EXPECT_EQ(scene.vertices, 6u);
    EXPECT_EQ(scene.normal[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.normal[3], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.uv[5], glm::vec2(1, 1));
    EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(SceneFromArrays, RefusesWhatContradictsItself)
{
    const std::vector<glm::vec3> three(3, glm::vec3(0));
    EXPECT_THROW(scene_from_arrays(three, {{0, 1, 3}}), SceneError);
    EXPECT_THROW(scene_from_arrays(three, {{0, 1, 2}}, {{0, 0, 1}}), SceneError);
    EXPECT_THROW(scene_from_arrays(three, {{0, 1, 2}}, {}, {{0, 0}}), SceneError);
    EXPECT_THROW(scene_from_arrays({glm::vec3(std::nanf(""))}, {}), SceneError);
    EXPECT_NO_THROW(scene_from_arrays({}, {}));
}

} // namespace
} // namespace firsthit::test
