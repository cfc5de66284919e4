// item_repair_test.cpp - what becomes of item pictures that are only nearly right.
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "hits/item_repair.h"
#include "instruction_sets.h"
#include "items.h"

#include <algorithm>
#include <array>

namespace firsthit::test {
namespace {

constexpr std::array kModes = {Multisample::none, Multisample::lazy3, Multisample::lazy5,
    Multisample::full3, Multisample::full5};

using ItemPicture = std::vector<std::uint32_t>; // (height, width)

struct Repaired {
    ItemPicture item;
    std::vector<bool> hole;
};

/// A world's triangles, and the size of its picture.
struct Seen {
    EyeWorld eye;
    int width, height;

    Seen(const World& world, const View& view)
        : eye(world, view),
          width(view.width),
          height(view.height)
    {
    }

    std::size_t at(int x, int y) const { return std::size_t(y * width + x); }
};

Repaired repaired(Seen& seen, const ItemPicture& picture, Multisample mode, int tile_size = 16)
{
    ViewMemory& view = seen.eye.memory;
    lay_out(Pencil(view.pencil), tile_size, view);
    TileItems tile;
    resize(tile, tile_size);
    Repaired out{ItemPicture(picture.size()), std::vector<bool>(picture.size())};
    for (int number = 0; number < view.tiles(); ++number) {
        std::vector<std::uint64_t> holes(std::size_t(tile.blocks()), 0);
        repair_tile_items(view, {view, picture, number}, mode, tile, holes);
        for (int y = 0; y < tile_size; ++y) {
            for (int x = 0; x < tile_size; ++x) {
                const int px = number % view.tiles_x * tile_size + x,
                          py = number / view.tiles_x * tile_size + y;
                const auto offset = std::size_t(tile_offset(x, y, tile_size));
                const bool hole = holes[offset / 64] >> offset % 64 & 1;
                if (px < seen.width && py < seen.height) {
                    out.item[seen.at(px, py)] = tile.item[offset];
                    out.hole[seen.at(px, py)] = hole;
                } else {
                    EXPECT_EQ(tile.item[offset], kNoItem);
                    EXPECT_FALSE(hole);
                }
            }
        }
    }
    return out;
}

/// The definition, sample by sample.
Repaired defined(const Seen& seen, const ItemPicture& picture, Multisample mode)
{
    Repaired out{ItemPicture(picture.size(), kNoItem), std::vector<bool>(picture.size())};
    const bool full = mode == Multisample::full3 || mode == Multisample::full5;
    const int reach = reach_of(mode);
    Effort effort;
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            const std::uint32_t own = picture[seen.at(x, y)];
            const glm::vec3 d = seen.eye.ray(x, y);
            const auto hit = [&](std::uint32_t id) {
                return id < seen.eye.triangles.index.size() &&
                       is_hit(seen.eye.triangles[id], d, effort) &&
                       seen.eye.triangles.is_there(id, d);
            };
            std::uint32_t& best = out.item[seen.at(x, y)];
            if (!full && own == kNoItem) continue;
            if (!full && hit(own)) {
                best = own;
                continue;
            }
            for (int ny = std::max(y - reach, 0); ny <= std::min(y + reach, seen.height - 1);
                 ++ny) {
                for (int nx = std::max(x - reach, 0); nx <= std::min(x + reach, seen.width - 1);
                     ++nx) {
                    const std::uint32_t id = picture[seen.at(nx, ny)];
                    if (!hit(id)) continue;
                    const int order = best == kNoItem ? -1
                                                      : compare_depth(seen.eye.triangles[id],
                                                            seen.eye.triangles[best], d, effort);
                    if (order < 0 || (order == 0 && id < best)) best = id;
                }
            }
            out.hole[seen.at(x, y)] = own != kNoItem && best == kNoItem;
        }
    }
    return out;
}

/// Shifted here, anything there.
ItemPicture corrupted(const Seen& seen, const ItemPicture& right, std::mt19937& random)
{
    ItemPicture wrong = right;
    const auto triangles = std::uint32_t(seen.eye.triangles.index.size());
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            const unsigned what = random() % 16;
            std::uint32_t& item = wrong[seen.at(x, y)];
            if (what < 3) item = right[seen.at(std::min(x + 1, seen.width - 1), y)];
            if (what == 3) item = kNoItem;
            if (what == 4) item = std::uint32_t(random()) % triangles;
            if (what == 5) item = triangles + std::uint32_t(random()) % 3;
            if (what == 6) item = kNoItem - 1;
        }
    }
    return wrong;
}

template <class F>
void for_adversarial_worlds(const F& check)
{
    View view = straight_view(kSize, kSize, kSize);
    for (std::size_t k = 0; k < 2 * adversarial_scenes().size(); ++k) {
        const AdversarialScene& scene = adversarial_scenes()[k / 2];
        const bool cutouts = k % 2 == 1;
        SCOPED_TRACE(scene.name + (cutouts ? " with cut-outs" : ""));
        std::mt19937 random(31);
        TestWorld world;
        scene.fill(world, random);
        world.finish();
        if (cutouts) make_cutouts(world, random, true);
        Seen seen(world.world, view);
        const ItemPicture right = brute_items(world.world, view);
        check(seen, right, random);
    }
}

TEST(Multisample, IsWhatItIsDefinedToBe)
{
    for_adversarial_worlds([&](Seen& seen, const ItemPicture& right, std::mt19937& random) {
        const ItemPicture wrong = corrupted(seen, right, random);
        for (const Multisample mode : kModes) {
            SCOPED_TRACE(int(mode));
            const Repaired expected = defined(seen, wrong, mode);
            for (const int tile_size : {16, 32, 40}) {
                const Repaired ours = repaired(seen, wrong, mode, tile_size);
                EXPECT_EQ(differences(ours.item, expected.item, seen.width), 0u);
                EXPECT_EQ(ours.hole, expected.hole);
            }
        }
    });
}

TEST(Multisample, IsTheSameForEveryInstructionSet)
{
    for_adversarial_worlds([&](Seen& seen, const ItemPicture& right, std::mt19937& random) {
        const ItemPicture wrong = corrupted(seen, right, random);
        for (const Multisample mode : kModes) {
            const Repaired expected = repaired(seen, wrong, mode);
            for_instruction_sets([&] {
                const Repaired ours = repaired(seen, wrong, mode);
                EXPECT_EQ(ours.item, expected.item);
                EXPECT_EQ(ours.hole, expected.hole);
            });
        }
    });
}

TEST(Multisample, LeavesARightPictureAlone)
{
    for_adversarial_worlds([&](Seen& seen, const ItemPicture& right, std::mt19937&) {
        for (const Multisample mode : kModes) {
            const Repaired ours = repaired(seen, right, mode);
            EXPECT_EQ(differences(ours.item, right, seen.width), 0u);
            EXPECT_EQ(ours.hole, std::vector<bool>(right.size())) << int(mode);
        }
    });
}

/// A square of two triangles, whose diagonal runs between samples.
struct Square {
    TestWorld world;
    View view = straight_view(20, 12, 12);

    Square()
    {
        world.add({-9, -9.01f, 4}, {9, -9, 4}, {9, 9, 4});
        world.add({-9, -9.01f, 4}, {9, 9, 4}, {-9, 9, 4});
        world.finish();
    }
};

TEST(Multisample, FindsTheNeighbourWhereAnItemIsOffByOnePixel)
{
    const Square square;
    Seen seen(square.world.world, square.view);
    const ItemPicture right = brute_items(square.world.world, square.view);
    ItemPicture wrong = right;
    for (std::size_t k = 0; k + 1 < right.size(); ++k) wrong[k] = right[k + 1];
    ASSERT_NE(wrong, right);
    for (const Multisample mode : {Multisample::lazy3, Multisample::full3})
        EXPECT_EQ(differences(repaired(seen, wrong, mode).item, right, seen.width), 0u);
    EXPECT_NE(repaired(seen, wrong, Multisample::none).item, right);
}

TEST(Multisample, FiveByFiveReachesTwoPixels)
{
    const Square square;
    Seen seen(square.world.world, square.view);
    const ItemPicture right = brute_items(square.world.world, square.view);
    // Nothing but a triangle that is missed, and the right one two samples away.
    const std::uint32_t hit = right[seen.at(15, 2)], missed = 1 - hit;
    ItemPicture wrong(right.size(), missed);
    wrong[seen.at(17, 4)] = hit;
    EXPECT_TRUE(repaired(seen, wrong, Multisample::lazy3).hole[seen.at(15, 2)]);
    EXPECT_EQ(repaired(seen, wrong, Multisample::lazy5).item[seen.at(15, 2)], hit);
    EXPECT_TRUE(repaired(seen, wrong, Multisample::full3).hole[seen.at(15, 2)]);
    EXPECT_EQ(repaired(seen, wrong, Multisample::full5).item[seen.at(15, 2)], hit);
}

TEST(Multisample, OnlyFullAsksWhereThereIsNoItem)
{
    const Square square;
    Seen seen(square.world.world, square.view);
    const ItemPicture right = brute_items(square.world.world, square.view);
    ItemPicture wrong = right;
    wrong[seen.at(7, 5)] = kNoItem;
    EXPECT_EQ(repaired(seen, wrong, Multisample::lazy5).item, wrong);
    EXPECT_EQ(repaired(seen, wrong, Multisample::full3).item, right);
}

TEST(Multisample, ExactTakesItemsAsTheyAre)
{
    const Square square;
    Seen seen(square.world.world, square.view);
    ItemPicture picture(20 * 12, 1);
    picture[3] = kNoItem;
    picture[5] = 2; // no triangle
    const Repaired ours = repaired(seen, picture, Multisample::exact);
    EXPECT_TRUE(ours.hole[5]);
    EXPECT_EQ(std::count(ours.hole.begin(), ours.hole.end(), true), 1);
    picture[5] = kNoItem;
    EXPECT_EQ(ours.item, picture);
}

} // namespace
} // namespace firsthit::test
