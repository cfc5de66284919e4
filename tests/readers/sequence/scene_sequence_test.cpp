// scene_sequence_test.cpp - numbered files are one animation.
#include "message_of.h"
#include "readers/sequence/sequence_files.h"
#include "scene/model/check_scene.h"
#include "test_data.h"

#include <firsthit/error.h>
#include <firsthit/sequence.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>

namespace firsthit {
namespace {

using test::cube_obj;
using test::triangle_obj;
using test::write_cubes;

/// Where corner k of a triangle is at a time.
glm::vec3 corner_at(SceneSequence& sequence, double time_s, std::size_t triangle, int k)
{
    World world;
    pose(sequence.scene_at(time_s), time_s, world);
    return world.position[world.scene->index[triangle][k]];
}

TEST(SceneSequence, HasAFrameForEachFileFromTheFirstNumberOn)
{
    const TemporaryFolder folder;
    for (const int k : {7, 8, 9}) folder.write(fmt::format("m{}.obj", k), cube_obj(k));
    SceneSequence sequence(folder / "m%d.obj", {.fps = 10});
    EXPECT_TRUE(sequence.is_numbered());
    EXPECT_EQ(sequence.frames(), 3u);
    EXPECT_EQ(sequence.file(0), folder / "m7.obj");
    EXPECT_EQ(sequence.time_s(1), 0.1);
    EXPECT_EQ(sequence.end_s(), 0.2);
    EXPECT_TRUE(sequence.warnings().empty());
    const auto scene = sequence.scene_at(0);
    EXPECT_EQ(scene->begin_s(), 0);
    EXPECT_EQ(scene->end_s(), 0.2);
    EXPECT_EQ(scene->frames(), 3);
}

TEST(SceneSequence, AtTheTimeOfAFrameIsItsFile)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 4), {.fps = 30});
    for (std::size_t k = 0; k < 4; ++k) {
        const Scene alone = load_scene(sequence.file(k));
        // Times that were computed in other ways are off by rounding.
        for (const double time_s : {sequence.time_s(k), sequence.time_s(k) * (1 - 1e-15),
                 sequence.time_s(k) * (1 + 1e-15)}) {
            World world;
            pose(sequence.scene_at(time_s), time_s, world);
            EXPECT_EQ(world.position, alone.position);
            EXPECT_EQ(world.scene->index, alone.index);
        }
    }
}

TEST(SceneSequence, PositionsAreInterpolatedLinearlyAndClampedAtBothEnds)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 4), {.fps = 1});
    const Scene first = load_scene(sequence.file(0));
    for (const double time_s : {0.25, 0.5, 1.75, 2.125, 2.9375, -3.0, 55.0}) {
        const auto moved = static_cast<float>(std::clamp(time_s, 0.0, 3.0));
        for (std::size_t t = 0; t < 12; ++t)
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 wanted = first.position[first.index[t][k]] + glm::vec3(moved, 0, 0);
                EXPECT_EQ(corner_at(sequence, time_s, t, k), wanted) << time_s;
            }
    }
    EXPECT_NO_THROW(check_scene(*sequence.scene_at(0.25)));
}

TEST(SceneSequence, NormalsAreInterpolatedAndUnit)
{
    const TemporaryFolder folder;
    folder.write("0.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    folder.write("1.obj", "v 0 0 0\nv 1 0 0\nv 0 0 -1\nvn 0 1 0\nf 1//1 2//1 3//1\n");
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    World world;
    pose(sequence.scene_at(0.25), 0.25, world);
    const glm::vec3 wanted = glm::normalize(glm::vec3(0, 0.25f, 0.75f));
    for (const glm::vec3& normal : world.normal) EXPECT_LT(glm::distance(normal, wanted), 1e-6f);
}

TEST(SceneSequence, CreasesThatComeAndGoKeepTheTopology)
{
    // A ridge of two triangles that folds from flat (smooth, 4 vertices) to sharp (creased, 6).
    const auto ridge = [](double height) {
        return fmt::format("v -1 0 0\nv 0 0 {0}\nv 0 1 {0}\nv 1 0 0\nf 1 2 3\nf 2 4 3\n", height);
    };
    const TemporaryFolder folder;
    folder.write("0.obj", ridge(0));
    folder.write("1.obj", ridge(2));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_EQ(sequence.frame(0)->vertex_count(), 4u);
    EXPECT_EQ(sequence.frame(1)->vertex_count(), 6u);
    EXPECT_TRUE(sequence.summary().new_topology.empty());

    // Both triangles see the ridge at the same place, and the normals of their own side.
    World world;
    pose(sequence.scene_at(0.5), 0.5, world);
    const Scene& scene = *world.scene;
    EXPECT_EQ(world.position[scene.index[0][1]], glm::vec3(0, 0, 1));
    EXPECT_EQ(world.position[scene.index[1][0]], glm::vec3(0, 0, 1));
    EXPECT_LT(world.normal[scene.index[0][1]].x, -0.1f);
    EXPECT_GT(world.normal[scene.index[1][0]].x, 0.1f);
}

TEST(SceneSequence, StandsStillWhereNothingMoves)
{
    const TemporaryFolder folder;
    for (const int k : {0, 1}) folder.write(fmt::format("{}.obj", k), cube_obj(0.1, 0.3));
    SceneSequence sequence(folder / "%d.obj");
    const Scene alone = load_scene(sequence.file(0));
    World world;
    for (int k = 0; k < 100; ++k) {
        pose(sequence.scene_at(k / 2400.0), k / 2400.0, world);
        EXPECT_EQ(world.position, alone.position);
    }
}

TEST(SceneSequence, ShowsTheEarlierFrameWhereTheTopologyChanges)
{
    const TemporaryFolder folder;
    folder.write("1.obj", cube_obj(0));
    folder.write("2.obj", triangle_obj(0));
    folder.write("3.obj", triangle_obj(4));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_EQ(sequence.scene_at(0)->triangle_count(), 12u);
    EXPECT_EQ(sequence.scene_at(0.999)->triangle_count(), 12u);
    EXPECT_EQ(sequence.scene_at(1 - 1e-9)->triangle_count(), 1u);
    EXPECT_EQ(sequence.scene_at(1)->triangle_count(), 1u);
    EXPECT_EQ(corner_at(sequence, 1.25, 0, 0).z, 1.0f);
    const SequenceSummary summary = sequence.summary();
    EXPECT_EQ(summary.triangles, (std::array<std::size_t, 2>{1, 12}));
    EXPECT_EQ(summary.vertices, (std::array<std::size_t, 2>{3, 24}));
    EXPECT_EQ(summary.new_topology, (std::vector<std::size_t>{1}));
    EXPECT_EQ(summary.bounds[1], glm::vec3(1, 1, 4));
}

TEST(SceneSequence, APolygonThatIsCutInAnotherWayKeepsTheTopology)
{
    // Two quads, of which the first folds: each frame cuts it along its own diagonal.
    const std::string quad = "v 0 0 {0}\nv 1 0 0\nv 1 1 {0}\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
    const TemporaryFolder folder;
    folder.write(
        "1.obj", fmt::format(fmt::runtime(quad), 0) + "f 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n");
    folder.write(
        "2.obj", fmt::format(fmt::runtime(quad), 1) + "f 1 2 4\nf 2 3 4\nf 5 6 2\nf 2 6 3\n");
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_TRUE(sequence.summary().new_topology.empty());
    // The triangles are the first frame's, their corners half way to the second's.
    EXPECT_EQ(corner_at(sequence, 0.5, 1, 1), glm::vec3(1, 1, 0.5f));
    EXPECT_EQ(corner_at(sequence, 0.5, 1, 2), glm::vec3(0, 1, 0));
    EXPECT_EQ(corner_at(sequence, 0.5, 2, 1), glm::vec3(2, 0, 0));
    EXPECT_NO_THROW(check_scene(*sequence.scene_at(0.5)));
}

TEST(SceneSequence, AsManyTrianglesOfOtherVerticesAreAnotherTopology)
{
    const TemporaryFolder folder;
    folder.write("1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
    folder.write("2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4\nf 1 4 2\n");
    EXPECT_EQ(SceneSequence(folder / "%d.obj").summary().new_topology.size(), 1u);
}

TEST(SceneSequence, FacetsThatNumberNoSharedVerticesAreOneTopologyWhereTheSameCornersCoincide)
{
    const auto stl = [](double x, double gap) {
        const auto facet = [](double ax, double bx, double cx) {
            return fmt::format("facet normal 0 0 0\nouter loop\nvertex {} 0 0\nvertex {} 0 0\n"
                               "vertex {} 1 0\nendloop\nendfacet\n",
                ax, bx, cx);
        };
        return "solid s\n" + facet(x, x + 1, x) + facet(x + 1 + gap, x + 2, x + 2) + "endsolid s\n";
    };
    const TemporaryFolder folder;
    folder.write("1.stl", stl(0, 0));
    folder.write("2.stl", stl(2, 0));
    folder.write("3.stl", stl(2, 0.25)); // the facets part
    SceneSequence sequence(folder / "%d.stl", {.fps = 1});
    EXPECT_EQ(sequence.summary().new_topology, (std::vector<std::size_t>{2}));
    EXPECT_EQ(corner_at(sequence, 0.5, 1, 1).x, 3.0f);
    EXPECT_EQ(corner_at(sequence, 1.5, 1, 0).x, 3.0f);
}

TEST(SceneSequence, FramesOnBothSidesOfAGapAreNeighbours)
{
    const TemporaryFolder folder;
    for (const int k : {1, 2, 5}) folder.write(fmt::format("{:03}.obj", k), cube_obj(k));
    SceneSequence sequence(folder / "%03d.obj", {.fps = 1});
    EXPECT_EQ(sequence.frames(), 3u);
    EXPECT_EQ(sequence.end_s(), 4);
    EXPECT_EQ(corner_at(sequence, 2.5, 0, 0).x, 3.5f); // of the cube that moves from 2 to 5
    EXPECT_EQ(sequence.scene_at(0)->frames(), 5);
    ASSERT_EQ(sequence.warnings().size(), 1u);
    EXPECT_EQ(sequence.warnings()[0],
        fmt::format("{0}/%03d.obj: 2 of the numbers from 1 to 5 have no file (the first is "
                    "{0}/003.obj): the frames on both sides of a gap follow each other",
            folder.path().string()));
    EXPECT_EQ(message_of<FileError>(
                  [&] { SceneSequence(folder / "%03d.obj", {.load = {.strict = true}}); }),
        sequence.warnings()[0]);
}

TEST(SceneSequence, AnErrorInTheMiddleNamesItsFileAndTheOthersAreStillRead)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 5), {.fps = 1});
    folder.write("frame_0003.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n");
    for (int round = 0; round < 2; ++round) {
        for (const double time_s : {0.5, 3.5, 4.0}) EXPECT_NO_THROW(sequence.scene_at(time_s));
        for (const double time_s : {1.5, 2.0, 2.5})
            EXPECT_NE(
                message_of<SceneError>([&] { sequence.scene_at(time_s); }).find("frame_0003.obj:4"),
                std::string::npos);
    }
    std::filesystem::remove(folder / "frame_0004.obj");
    SceneSequence others(folder / "frame_%04d.obj", {.fps = 1});
    folder.write("frame_0003.obj", cube_obj(3));
    EXPECT_NO_THROW(sequence.scene_at(2));
}

TEST(SceneSequence, ReadsAFileAgainThatWasDamagedWhenItWasReadAhead)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 6), {.fps = 1});
    folder.write("frame_0003.obj", "f 1 2 3\n");
    EXPECT_NO_THROW(sequence.scene_at(0));
    EXPECT_NO_THROW(sequence.scene_at(1)); // reads the third ahead
    EXPECT_THROW(sequence.scene_at(2), Error);
    folder.write("frame_0003.obj", cube_obj(3));
    EXPECT_NO_THROW(sequence.scene_at(2));
}

TEST(SceneSequence, FilesAreThoseOfAllFramesAndTheLibrariesOfItsOwn)
{
    const TemporaryFolder folder;
    folder.write("1.obj", "mtllib one.mtl\n" + cube_obj(1));
    folder.write("2.obj", "mtllib two.mtl\n" + cube_obj(2));
    folder.write("one.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("two.mtl", "newmtl a\nKd 0 1 0\n");
    SceneSequence sequence(folder / "%d.obj");
    using Files = std::vector<std::string>;
    const std::string one = folder / "1.obj", two = folder / "2.obj";
    EXPECT_EQ(sequence.frame(0)->files, (Files{one, two, folder / "one.mtl"}));
    EXPECT_EQ(sequence.frame(1)->files, (Files{one, two, folder / "two.mtl"}));
}

TEST(SceneSequence, TheLightOfFilesWithoutLightsStandsStill)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 3), {.fps = 1});
    const Scene alone = load_scene(sequence.file(0));
    ASSERT_EQ(alone.lights.size(), 1u);
    for (const double time_s : {0.0, 0.5, 2.0}) {
        const auto scene = sequence.scene_at(time_s);
        ASSERT_EQ(scene->lights.size(), 1u);
        EXPECT_EQ(scene->lights[0].position, alone.lights[0].position);
    }
}

TEST(SceneSequence, ChangesEverySceneBeforeItIsSeen)
{
    const TemporaryFolder folder;
    SequenceSettings settings;
    settings.fps = 1;
    settings.change = [](Scene& scene) { scene.ambient = glm::vec3(0.25f); };
    SceneSequence sequence(write_cubes(folder, 3), settings);
    for (const double time_s : {0.0, 0.5, 2.0})
        EXPECT_EQ(sequence.scene_at(time_s)->ambient, glm::vec3(0.25f));
    EXPECT_EQ(SceneSequence("builtin:torus", settings).scene_at(0)->ambient, glm::vec3(0.25f));
}

TEST(SceneSequence, AFileWithAnimationsIsShownAsItsFirstClipBegins)
{
    // One triangle below a node that moves; both files have the same buffer.
    const auto gltf = [](double x) {
        return fmt::format(
            R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"scene":0,
            "nodes":[{{"name":"hung","translation":[{},0,0],"mesh":0}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
            "min":[0,0,0],"max":[1,1,0]}}],"bufferViews":[{{"buffer":0,"byteLength":36}}],
            "buffers":[{{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
            R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}]}})",
            x);
    };
    const TemporaryFolder folder;
    folder.write("1.gltf", gltf(0));
    folder.write("2.gltf", gltf(4));
    SceneSequence sequence(folder / "%d.gltf", {.fps = 1});
    EXPECT_EQ(corner_at(sequence, 0.25, 0, 0), glm::vec3(1, 0, 0));
    EXPECT_EQ(sequence.scene_at(0.25)->nodes[0].name, "hung");
    EXPECT_NO_THROW(check_scene(*sequence.scene_at(0.25)));
}

TEST(SceneSequence, IsASingleSceneWhereTheNameHasNoNumber)
{
    SceneSequence sequence("builtin:robots");
    EXPECT_FALSE(sequence.is_numbered());
    EXPECT_EQ(sequence.frames(), 1u);
    EXPECT_EQ(sequence.scene_at(0), sequence.scene_at(7));
    EXPECT_EQ(sequence.end_s(), sequence.scene_at(0)->end_s());
    EXPECT_EQ(sequence.file(0), "builtin:robots");
    EXPECT_GT(sequence.summary().triangles[0], 0u);

    const TemporaryFolder folder;
    EXPECT_FALSE(is_sequence_name(folder.write("100%d.obj", cube_obj(0)).string()));
    EXPECT_TRUE(is_sequence_name(folder / "%d.obj"));
    EXPECT_FALSE(is_sequence_name("builtin:%d"));
}

TEST(SceneSequence, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    EXPECT_EQ(message_of<FileError>([&] { SceneSequence(folder / "x%02d.obj"); }),
        fmt::format("{0}/x%02d.obj: there is no file of that pattern, such as {0}/x01.obj",
            folder.path().string()));
    EXPECT_THROW(SceneSequence(folder / "%s.obj"), ArgumentError);
    EXPECT_THROW(SceneSequence(folder / "%d%d.obj"), ArgumentError);
    EXPECT_EQ(message_of<ArgumentError>([] { SceneSequence("%d.obj", {.fps = 0}); }),
        "%d.obj: 0 frames a second: accepted are 1e-06 to 1000000");
    EXPECT_THROW(SceneSequence("%d.obj", {.fps = std::nan("")}), ArgumentError);
    SceneSequence sequence(write_cubes(folder, 1));
    EXPECT_THROW(sequence.scene_at(std::numeric_limits<double>::infinity()), ArgumentError);
    EXPECT_THROW(sequence.frame(1), ArgumentError);
    EXPECT_EQ(sequence.scene_at(1e300)->triangle_count(), 12u);
    EXPECT_EQ(sequence.scene_at(-1e300)->triangle_count(), 12u);
    EXPECT_TRUE(SceneSequence(folder / "frame_%04d.obj").warnings().empty());
}

TEST(SceneSequence, KeepsFewFramesHoweverManyThereAre)
{
    const TemporaryFolder folder;
    SceneSequence sequence(write_cubes(folder, 100), {.fps = 1});
    std::vector<std::weak_ptr<const Scene>> frames;
    for (int k = 0; k < 100; ++k) frames.push_back(sequence.scene_at(k));
    for (int k = 0; k < 990; ++k) (void)sequence.scene_at(k / 10.0);
    for (int k = 99; k >= 0; --k) frames.push_back(sequence.scene_at(k));
    std::set<const Scene*> alive;
    for (const auto& frame : frames)
        if (const auto scene = frame.lock()) alive.insert(scene.get());
    EXPECT_LE(alive.size(), 4u);
}

TEST(SceneSequence, AWorldKeepsWhatItWasPosedFrom)
{
    const TemporaryFolder folder;
    World world;
    {
        SceneSequence sequence(write_cubes(folder, 30), {.fps = 1});
        pose(sequence.scene_at(0.5), 0.5, world);
        for (int k = 0; k < 30; ++k) (void)sequence.scene_at(k);
    }
    pose(world.scene, 0.75, world);
    EXPECT_EQ(bounds(world)[0], glm::vec3(1.75f, 0, 0));
}

TEST(SceneSequence, TheHorseGallopsOnOneTopology)
{
    const auto data = test_data("horse-gallop");
    if (!data) GTEST_SKIP() << "FIRSTHIT_TEST_DATA has no horse-gallop";
    SceneSequence sequence((*data / "%04d.obj").string());
    const SequenceSummary summary = sequence.summary();
    EXPECT_EQ(sequence.frames(), 16u);
    EXPECT_TRUE(summary.new_topology.empty());
    EXPECT_EQ(summary.triangles, (std::array<std::size_t, 2>{16843, 16843}));

    // Half way, corners are half way between those of both files.
    const Scene a = load_scene(sequence.file(3)), b = load_scene(sequence.file(4));
    for (std::size_t t = 0; t < a.triangle_count(); t += 97)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 wanted =
                0.5f * a.position[a.index[t][k]] + 0.5f * b.position[b.index[t][k]];
            EXPECT_LT(glm::distance(corner_at(sequence, 3.5 / 24, t, k), wanted), 1e-6f);
        }
}

} // namespace
} // namespace firsthit
