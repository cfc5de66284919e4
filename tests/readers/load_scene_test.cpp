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
    for (const char* const name : {"a.fbx", "noending", "a.ply.gz", ""})
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
        "builtin:torus, builtin:robots, builtin:wave?n=N");
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

TEST(LoadScene, LightsAFileWithoutLightsFromTheCamerasSide)
{
    const TemporaryFolder folder;
    const Scene scene = load_scene(folder.write("a.obj", kCubeObj).string());
    ASSERT_EQ(scene.lights.size(), 1u);
    const glm::dvec3 from_middle = scene.lights[0].position - glm::dvec3(0.5);
    EXPECT_GT(from_middle.x, 0.5); // right
    EXPECT_GT(from_middle.y, 0.5); // up
    EXPECT_GT(from_middle.z, 0.5); // in front
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
