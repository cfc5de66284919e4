// hit_runs_test.cpp - what resolve keeps of runs and of blocks, and that their number changes no bit.
#include "hits/known_run.h"
#include "instruction_sets.h"
#include "scene/model/borrow.h"
#include "shadow/map/hit_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace firsthit::test {
namespace {

/// A built-in scene, the whole of it in view.
struct Posed {
    Scene scene;
    World world;
    View view;

    explicit Posed(const std::string& name, int size = 96) : scene(load_scene(name))
    {
        pose(borrow(scene), 0, world);
        view = {.camera = framing_camera(world), .width = size, .height = size, .region = {}};
    }
};

TEST(HitRuns, KnowThePlanesThatTheirCornersSpan)
{
    for (const char* const name : {"builtin:torus", "builtin:wave?n=200", "builtin:wave?n=20000"}) {
        SCOPED_TRACE(name);
        const Posed posed(name);
        Tasks tasks(1);
        const HitPicture picture(posed.world, posed.view, tasks);
        std::size_t runs = 0;
        for (const auto& tile : picture.tiles)
            for (const HitRun& run : tile->hits.runs) {
                ASSERT_TRUE(run.has_plane());
                const HitRun expected = with_plane(run, posed.world, tile->hits.rays);
                const glm::vec4 apart = glm::abs(run.plane - expected.plane);
                EXPECT_LT(std::max({apart.x, apart.y, apart.z}), 2e-4f);
                EXPECT_NEAR(run.plane.w / expected.plane.w, 1, 2e-3);
                ++runs;
            }
        EXPECT_GT(runs, 100u);
    }
}

TEST(HitRuns, WithoutAreaOrBelowTheEyeHaveNoPlane)
{
    Scene scene;
    World world;
    world.scene = borrow(scene);
    world.position = {{0, 0, -4}, {1, 0, -4}, {2, 0, -4}, {0, 3, -4}, {0, 0, 0}};
    scene.index = {{0, 1, 2}, {4, 0, 3}, {0, 1, 3}};
    EXPECT_FALSE(with_plane({.item = 0}, world, Rays{}).has_plane());
    EXPECT_FALSE(with_plane({.item = 1}, world, Rays{}).has_plane());
    const HitRun run = with_plane({.item = 2}, world, Rays{});
    EXPECT_EQ(run.plane, glm::vec4(0, 0, 1, 4));
}

TEST(HitRuns, OfAnyNumberInABlockGiveTheSameBitsOnEveryInstructionSet)
{
    std::map<std::size_t, int> blocks_with; // so many runs
    for (const char* const name : {"builtin:torus", "builtin:wave?n=100", "builtin:wave?n=500",
             "builtin:wave?n=1500", "builtin:wave?n=4000", "builtin:wave?n=30000"}) {
        SCOPED_TRACE(name);
        const Posed posed(name);
        Tasks tasks(1);
        const HitPicture best(posed.world, posed.view, tasks);
        for (const auto& tile : best.tiles) {
            std::map<std::uint16_t, std::size_t> in_block;
            for (const HitRun& run : tile->hits.runs) ++in_block[run.block];
            for (const auto& [block, count] : in_block) ++blocks_with[count];
        }
        for_instruction_sets([&] {
            const HitPicture other(posed.world, posed.view, tasks);
            for (std::size_t k = 0; k < best.tiles.size(); ++k) {
                const HitTile &a = best.tiles[k]->hits, &b = other.tiles[k]->hits;
                const auto samples = std::size_t(a.size) * std::size_t(a.size);
                const auto same = [&](const auto* x, const auto* y) {
                    return std::equal(x, x + samples, y);
                };
                ASSERT_TRUE(
                    same(a.item, b.item) && same(a.t, b.t) && same(a.u, b.u) && same(a.v, b.v));
                ASSERT_EQ(a.runs.size(), b.runs.size());
                for (std::size_t i = 0; i < a.runs.size(); ++i) {
                    ASSERT_EQ(a.runs[i].samples, b.runs[i].samples);
                    ASSERT_EQ(a.runs[i].eye_side, b.runs[i].eye_side);
                    ASSERT_EQ(a.runs[i].plane, b.runs[i].plane);
                }
            }
        });
    }
    // All that is done otherwise where there are few, some or many.
    for (std::size_t count = 1; count <= 20; ++count) EXPECT_GT(blocks_with[count], 0) << count;
}

TEST(HitRuns, OfOtherBlocksAreAllThatIsWrittenWhereMissesAreNot)
{
    const Posed posed("builtin:torus");
    Tasks tasks(1);
    HitPicture picture(posed.world, posed.view, tasks);
    constexpr float kUntouched = 17;
    int empty = 0, covered = 0;
    for (const auto& tile : picture.tiles) {
        HitMemory memory;
        resize(memory, tile->items.size, 1);
        memory.misses = memory.items = false;
        std::fill_n(memory.t.data(), memory.samples, kUntouched);
        const HitTile hits =
            resolve_tile(picture.view, picture.view.pencil, tile->items, memory.of(0));
        EXPECT_EQ(hits.item, nullptr);
        for (int block = 0; block < int(hits.blocks()); ++block) {
            ++(hits.is_empty(block) ? empty : covered);
            for (int k = 0; k < kBlockSamples; ++k) {
                const auto at = std::size_t(block * kBlockSamples + k);
                const bool hit = tile->items.item[at] != kNoItem;
                EXPECT_EQ(hits.covered[block] >> k & 1, hit);
                EXPECT_EQ(hits.t[at], hits.is_empty(block) ? kUntouched : tile->hits.t[at]);
            }
        }
    }
    EXPECT_GT(empty, 0);
    EXPECT_GT(covered, 0);
}

} // namespace
} // namespace firsthit::test
