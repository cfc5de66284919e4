// raster_tile_test.cpp - what the item buffer's proof rests on: boxes that hold every hit, and
// depths within their bound.
#include "cpu/adversarial_scenes.h"
#include "items.h"
#include "visibility/bin/bin_triangles.h"
#include "visibility/raster/raster_tile.h"
#include "visibility/bin/triangle_box.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace firsthit::test {
namespace {

/// What one worker needs to rasterise tiles of 16 samples.
struct Raster {
    TileItems items;
    RasterScratch scratch{};

    Raster()
    {
        resize(items, 16);
        resize(scratch, 16);
    }

    void tile(const ViewMemory& view, int number)
    {
        raster_tile(view, view.rays(number), bin_of(view, std::size_t(number)), items, scratch);
    }
};

/// A world, binned for tiles of 16 samples.
struct Binned {
    ViewMemory memory;

    Binned(const World& world, const View& view, TinyTriangles tiny = TinyTriangles::items,
        CornerSpace space = CornerSpace::eye)
    {
        Tasks tasks(1);
        const View filled = checked(view);
        lay_out(pencil_of(filled, filled.region, 1), 16, memory);
        take_triangles(*world.scene, memory);
        project_vertices(world.position, memory.pencil, memory, tasks, space);
        bin_triangles(memory, memory, memory, tasks, tiny);
    }
};

template <class F>
void for_adversarial_worlds(const F& check)
{
    for (const AdversarialScene& scene : adversarial_scenes()) {
        for (unsigned seed = 20; seed < 22; ++seed) {
            SCOPED_TRACE(scene.name);
            std::mt19937 random(seed);
            TestWorld world;
            scene.fill(world, random);
            world.finish();
            check(world.world);
        }
    }
}

TEST(BinTriangles, HoldsEverySampleThatATriangleHits)
{
    const View view = straight_view(kSize, kSize, kSize);
    for_adversarial_worlds([&](const World& world) {
        const Binned binned(world, view);
        const EyeWorld eye(world, view);
        Effort effort;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const int tile = y / 16 * binned.memory.tiles_x + x / 16;
                std::vector<bool> listed(world.scene->index.size());
                for (std::uint32_t e = binned.memory.tile_start[std::size_t(tile)];
                     e < binned.memory.tile_start[std::size_t(tile) + 1]; ++e) {
                    const TileEntry& entry = binned.memory.entry[e];
                    if (x % 16 >= entry.x0 && x % 16 <= entry.x1 && y % 16 >= entry.y0 &&
                        y % 16 <= entry.y1)
                        listed[entry.triangle] = true;
                }
                const std::uint32_t* start = &binned.memory.fragment_start[std::size_t(tile)];
                const int sample = tile << 16 | tile_offset(x % 16, y % 16, 16);
                for (std::uint32_t f = start[0]; f < start[1]; ++f)
                    if (int(binned.memory.fragment[f].sample) == sample)
                        listed[binned.memory.fragment[f].triangle] = true;
                for (std::size_t t = 0; t < listed.size(); t += 3) // a third is enough
                    EXPECT_TRUE(listed[t] || !is_hit(eye.triangles[t], eye.ray(x, y), effort));
            }
        }
    });
}

/// Items of all tiles, tile by tile.
std::vector<std::uint32_t> items_of_tiles(const Binned& binned)
{
    const auto raster = std::make_unique<Raster>();
    std::vector<std::uint32_t> items;
    for (int number = 0; number < binned.memory.tiles(); ++number) {
        raster->tile(binned.memory, number);
        const std::span<const std::uint32_t> item = raster->items.item.span();
        items.insert(items.end(), item.begin(), item.end());
    }
    return items;
}

TEST(TinyTriangles, GiveTheItemsThatEntriesGive)
{
    const View view = straight_view(kSize, kSize, kSize);
    for_adversarial_worlds([&](const World& world) {
        EXPECT_EQ(items_of_tiles(Binned(world, view)),
            items_of_tiles(Binned(world, view, TinyTriangles::entries)));
    });
}

TEST(TinyTriangles, BecomeEntriesWhereTheirSamplesFindNoRoom)
{
    const View view = straight_view(kSize, kSize, kSize);
    TestWorld world; // ten samples each
    for (int k = 0; k < 8000; ++k) {
        const float z = 4 + float(k % 7) / 8, x = float(k % 40 - 20) + .3f,
                    y = float(k / 40 % 40 - 20) + .3f;
        const auto at = [&](float dx, float dy) {
            return glm::vec3((x + dx) * z / kSize, (y + dy) * z / kSize, z);
        };
        world.add(at(0, 0), at(3.8f, 0), at(0, 3.8f));
    }
    world.finish();
    const Binned binned(world.world, view);
    EXPECT_GT(binned.memory.fragment.size(), 60000u);
    EXPECT_GT(binned.memory.entry_count, 1000u);
    EXPECT_EQ(
        items_of_tiles(binned), items_of_tiles(Binned(world.world, view, TinyTriangles::entries)));
}

TEST(TinyTriangles, AreMostlyCertain)
{
    std::mt19937 random(1);
    TestWorld world;
    for (const AdversarialScene& scene : adversarial_scenes())
        if (scene.name == "folded mesh") scene.fill(world, random);
    world.finish();
    const Binned binned(world.world, straight_view(kSize, kSize, kSize));
    EXPECT_LT(binned.memory.entry_count, binned.memory.in_view_count / 4);
}

TEST(BinTriangles, LeavesOutWhatIsBehindOrBeside)
{
    TestWorld world;
    world.add({-1, -1, -2}, {1, -1, -2}, {0, 1, -2});   // behind
    world.add({-1, -1, -2}, {1, -1, -2}, {0, 1, 0});    // up to the eye's plane
    world.add({9, -1, 2}, {12, -1, 2}, {9, 1, -3});     // crosses the plane, to the right
    world.add({-9, -1, 2}, {-12, -1, 2}, {-9, 1, -3});  // to the left
    world.add({0, -20, 2}, {1, -20, 2}, {0, -25, -3});  // above
    world.add({0, 0, 1}, {1e-4f, 0, 1}, {0, 1e-4f, 1}); // between samples
    world.finish();
    EXPECT_EQ(Binned(world.world, straight_view(kSize, kSize, kSize)).memory.in_view_count, 0u);
}

TEST(BinTriangles, FindsAroundTheEyeWhatEachTrianglesBoxSays)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    TestWorld world;
    const auto corner = [&] {
        const float x = number(random), y = number(random), z = number(random);
        return glm::vec3(x, y, random() % 4 ? z : 0.0f); // in the eye's plane as well
    };
    for (int k = 0; k < 3000; ++k) {
        const glm::vec3 a = corner(), b = corner(), c = corner();
        world.add(a, b, c);
    }
    world.finish();
    const View view = straight_view(kSize, kSize, kSize);
    for (const CornerSpace space : {CornerSpace::eye, CornerSpace::flat}) {
        Binned binned(world.world, view, TinyTriangles::entries, space);
        std::vector<bool> found(world.world.scene->index.size()), boxed(found.size());
        for (const TileEntry& entry : binned.memory.entry.span()) found[entry.triangle] = true;
        InView box;
        for (std::uint32_t t = 0; t < boxed.size(); ++t)
            boxed[t] = box_of(t, binned.memory, binned.memory.pencil, box);
        EXPECT_EQ(found, boxed);
        EXPECT_GT(std::count(found.begin(), found.end(), true), 500);
        EXPECT_GT(std::count(found.begin(), found.end(), false), 500);
    }
}

TEST(RasterTile, StoresDepthsWithinTheirBound)
{
    const View view = straight_view(kSize, kSize, kSize);
    for_adversarial_worlds([&](const World& world) {
        const Binned binned(world, view);
        const auto raster = std::make_unique<Raster>();
        const TileItems& tile = raster->items;
        for (int number = 0; number < binned.memory.tiles(); ++number) {
            raster->tile(binned.memory, number);
            const EyeWorld eye(world, view);
            for (int y = 0; y < 16; ++y) {
                for (int x = 0; x < 16; ++x) {
                    const std::size_t at = std::size_t(tile_offset(x, y, 16));
                    if (tile.item[at] == kNoItem) continue;
                    const glm::vec3 d = tile.rays.direction(x, y);
                    const double exact = std::min(
                        exact_inverse_depth(eye.triangles[tile.item[at]], d), double(kGreatestW));
                    EXPECT_LE(std::abs(raster->scratch.w[at] - exact), double(kDepthError) * exact);
                }
            }
        }
    });
}

} // namespace
} // namespace firsthit::test
