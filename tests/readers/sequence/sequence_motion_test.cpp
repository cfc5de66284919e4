// sequence_motion_test.cpp - what moves in a sequence goes on over the borders of its files.
#include "message_of.h"
#include "readers/sequence/sequence_files.h"
#include "scenes.h"

#include <firsthit/error.h>
#include <firsthit/render.h>
#include <firsthit/sequence.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace firsthit {
namespace {

using test::cube_obj;
using test::straight_view;
using test::triangle_obj;
using test::write_cubes;

/// A square of two triangles at z = 10, moved along x. Every other file is folded a little behind the picture's
/// border, so that files differ in the number of their vertices.
std::string plate_obj(double x, bool is_folded)
{
    return fmt::format(
        "v {0} -1 10\nv {1} -1 10\nv {1} 1 10\nv {0} 1 10\nv {0} 30 {2}\nv {1} 30 {2}\n"
        "f 1 2 3\nf 1 3 4\nf 4 3 6\nf 4 6 5\n",
        x, x + 2, is_folded ? 40 : 10);
}

TEST(SequenceMotion, IsTheSameWithinAPairOfFilesAndOverItsBorder)
{
    const TemporaryFolder folder;
    for (int k = 0; k < 5; ++k)
        folder.write(fmt::format("{}.obj", k), plate_obj(-2 + 0.5 * k, k % 2 == 1));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_NE(sequence.frame(0)->vertex_count(), sequence.frame(1)->vertex_count());

    const View view = straight_view(64, 48, 80);
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item, Aov::motion, Aov::motion_visible};
    Renderer renderer(1);
    World before, now;
    Film film;
    constexpr double kStep = 0.4; // s; it meets borders and the middle of pairs
    for (int frame = 0; frame * kStep <= 4; ++frame) {
        const double time_s = frame * kStep;
        renderer.pose(sequence.scene_at(time_s), time_s, now);
        if (frame > 0) {
            EXPECT_TRUE(sequence.same_triangles(time_s - kStep, time_s)) << time_s;
            settings.previous = {&before, view.camera};
            renderer.render(now, view, settings, film);
            int seen = 0;
            for (std::size_t k = 0; k < film.item.size(); ++k) {
                if (film.item[k] > 1) continue;
                ++seen;
                // 80 pixels at distance 1 are 8 at distance 10.
                EXPECT_NEAR(film[Aov::motion].value[2 * k], kStep * 0.5 * 8, 1e-4) << time_s;
                EXPECT_NEAR(film[Aov::motion].value[2 * k + 1], 0, 1e-4) << time_s;
                EXPECT_EQ(film[Aov::motion_visible].value[k], 1) << time_s;
            }
            EXPECT_GT(seen, 100);
        }
        std::swap(now, before);
    }
}

TEST(SequenceMotion, AWorldIsPosedBackAndForthAsIfItWereNew)
{
    const TemporaryFolder folder;
    for (int k = 0; k < 6; ++k)
        folder.write(fmt::format("{}.obj", k), plate_obj(0.3 * k, k % 2 == 1));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    Renderer renderer(1);
    World kept;
    for (const double time_s : {0.0, 4.75, 4.25, 1.5, 2.0, 1.75, 5.0, 0.5, 3.0, 2.999, 0.25}) {
        renderer.pose(sequence.scene_at(time_s), time_s, kept);
        SceneSequence other(folder / "%d.obj", {.fps = 1});
        World fresh;
        pose(other.scene_at(time_s), time_s, fresh);
        EXPECT_EQ(kept.position, fresh.position) << time_s;
        EXPECT_EQ(kept.normal, fresh.normal) << time_s;
        EXPECT_EQ(kept.scene->index, fresh.scene->index) << time_s;
        EXPECT_EQ(kept.lights.size(), fresh.lights.size()) << time_s;
    }
}

TEST(SequenceMotion, PositionsAndNormalsAreContinuousAtEachFile)
{
    const TemporaryFolder folder;
    for (int k = 0; k < 4; ++k)
        folder.write(fmt::format("{}.obj", k), plate_obj(0.3 * k, k % 2 == 1));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    for (const double border : {1.0, 2.0}) {
        World at, near;
        pose(sequence.scene_at(border), border, at);
        for (const double time_s : {border - 1e-5, border + 1e-5}) {
            pose(sequence.scene_at(time_s), time_s, near);
            EXPECT_NE(near.scene, at.scene);
            for (std::size_t t = 0; t < 4; ++t)
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t a = at.scene->index[t][k], b = near.scene->index[t][k];
                    EXPECT_LT(glm::distance(at.position[a], near.position[b]), 4e-4f) << time_s;
                    EXPECT_LT(glm::distance(at.normal[a], near.normal[b]), 1e-4f) << time_s;
                }
        }
    }
}

TEST(SequenceMotion, TrianglesAreTheSameWhereTheTopologyAndItsCutAre)
{
    const TemporaryFolder folder;
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    folder.write("1.obj", corners + "f 1 2 3\nf 1 3 4\n");
    folder.write("2.obj", corners + "v 9 9 9\nf 1 2 3\nf 1 3 4\n");
    folder.write("3.obj", corners + "f 1 2 4\nf 2 3 4\n"); // cut along the other diagonal
    folder.write("4.obj", triangle_obj(0));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_TRUE(sequence.same_triangles(0, 0.5));
    EXPECT_TRUE(sequence.same_triangles(0.5, 1));
    EXPECT_TRUE(sequence.same_triangles(1.9, 0.2));
    EXPECT_FALSE(sequence.same_triangles(1.9, 2));
    EXPECT_FALSE(sequence.same_triangles(2, 3));
    EXPECT_TRUE(sequence.same_triangles(3, 99));
    EXPECT_THROW(sequence.same_triangles(0, std::nan("")), ArgumentError);
    EXPECT_TRUE(SceneSequence("builtin:robots").same_triangles(0, 7));
}

TEST(SequenceMotion, AFrameBeforeOfOtherTrianglesIsRefused)
{
    const TemporaryFolder folder;
    folder.write("1.obj", cube_obj(0));
    folder.write("2.obj", triangle_obj(0));
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    Renderer renderer(1);
    World before, now;
    renderer.pose(sequence.scene_at(0), 0, before);
    renderer.pose(sequence.scene_at(1), 1, now);
    const View view = straight_view(16, 16, 80);
    Settings settings;
    settings.aovs = {Aov::motion};
    settings.previous = {&before, view.camera};
    Film film;
    EXPECT_NE(message_of<ArgumentError>([&] {
        renderer.render(now, view, settings, film);
    }).find("other triangles"),
        std::string::npos);
}

} // namespace
} // namespace firsthit
