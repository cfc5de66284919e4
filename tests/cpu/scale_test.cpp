// scale_test.cpp - many triangles: none dropped, none renamed.
#include "items.h"
#include "scenes.h"

#include <algorithm>
#include <random>

namespace firsthit::test {
namespace {

/// Quads of a width x height grid of pixels at depth z, two triangles each, every one centred on a
/// pixel of straight_view(width, height, height).
void add_pixel_grid(TestWorld& world, int width, int height, float z)
{
    const auto first = std::uint32_t(world.world.position.size());
    for (int y = 0; y <= height; ++y)
        for (int x = 0; x <= width; ++x)
            world.world.position.push_back({(float(x) - float(width) / 2) * z / float(height),
                (float(y) - float(height) / 2) * z / float(height), z});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint32_t a = first + std::uint32_t(y * (width + 1) + x);
            const std::uint32_t c = a + std::uint32_t(width + 1);
            world.scene->index.push_back({a, a + 1, c + 1});
            world.scene->index.push_back({a, c + 1, c});
        }
    }
}

TEST(Scale, OneTriangleHidesAMillionTinyOnes)
{
    TestWorld world;
    add_pixel_grid(world, 710, 710, 4);
    const auto cover = std::uint32_t(world.scene->index.size());
    ASSERT_GT(cover, 1000000u);
    world.add({-9, -9, 3}, {9, -9, 3}, {0, 9, 3});
    world.finish();
    const View view = straight_view(710, 710, 710);
    std::size_t other = 0;
    for (const std::uint32_t item : items_of(world.world, view, 2)) other += item != cover;
    EXPECT_EQ(other, 0u);
}

TEST(Scale, EveryPixelOfAMillionTrianglesSeesItsOwn)
{
    TestWorld world;
    add_pixel_grid(world, 710, 710, 4);
    world.finish();
    const std::vector<std::uint32_t> items = items_of(world.world, straight_view(710, 710, 710), 2);
    std::size_t wrong = 0;
    // The centre lies on the diagonal of its quad: one of its two triangles.
    for (std::size_t i = 0; i < items.size(); ++i) wrong += items[i] / 2 != i;
    EXPECT_EQ(wrong, 0u);
}

TEST(Scale, DropsNoneOfTwoHundredThousandFacesInOneTile)
{
    // Every face covers all of a 32x32 picture, each nearer than the one before.
    TestWorld world;
    const std::uint32_t count = 200000;
    for (std::uint32_t k = 0; k < count; ++k) {
        const float z = 8 - 4 * float(k) / float(count);
        world.add({-9 * z, -9 * z, z}, {9 * z, -9 * z, z}, {0, 9 * z, z});
    }
    world.finish();
    for (const std::uint32_t item : items_of(world.world, straight_view(32, 32, 32)))
        ASSERT_EQ(item, count - 1);
}

TEST(Scale, DividesPicturesWithTooManyTrianglesInEveryTile)
{
    // 140,000 triangles over 17 x 16 tiles would be 38 million entries.
    TestWorld world;
    const std::uint32_t count = 140000, nearest = count / 2;
    for (std::uint32_t k = 0; k < count; ++k) {
        const float z = k == nearest ? 1 : 2 + float(k) * 0x1p-10f;
        world.add({-9 * z, -9 * z, z}, {9 * z, -9 * z, z}, {0, 9 * z, z});
    }
    world.finish();
    const auto items = items_of(world.world, straight_view(1030, 1000, 1000), 2);
    EXPECT_EQ(std::size_t(std::count(items.begin(), items.end(), nearest)), items.size());
}

TEST(Scale, NamesTheLastOfSixteenMillionAndOneTriangles)
{
    TestWorld world;
    world.world.position = {{90, 0, 4}, {91, 0, 4}, {90, 1, 4}, {-9, -9, 3}, {9, -9, 3}, {0, 9, 3}};
    const std::uint32_t last = 1u << 24;
    world.scene->index.assign(last, glm::uvec3(0, 1, 2));
    world.scene->index.push_back({3, 4, 5});
    world.finish();
    for (const std::uint32_t item : items_of(world.world, straight_view(32, 32, 32), 2))
        ASSERT_EQ(item, last);
}

TEST(Scale, DividesPicturesThatAreTooLargeForOnePass)
{
    // 9000 x 40: two parts side by side; small tiles: many parts.
    TestWorld world;
    std::mt19937 random(6);
    std::uniform_real_distribution<float> x(-110, 110), y(-1, 1);
    for (int k = 0; k < 3000; ++k) {
        const float cx = x(random), cy = y(random);
        world.add({cx, cy, 1}, {cx + y(random), cy + y(random), 1.5f}, {cx, cy + y(random), 2});
    }
    world.finish();
    const View view = straight_view(9000, 40, 40);
    const auto expected = items_of(world.world, view, 2);
    EXPECT_EQ(items_of(world.world, view, 2, 8), expected);
    View part = view;
    part.region = {8100, 0, 300, 40};
    const auto seam = items_of(world.world, part);
    const auto brute = brute_items(world.world, part);
    EXPECT_EQ(differences(seam, brute, 300), 0u);
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 300; ++column)
            ASSERT_EQ(seam[std::size_t(row * 300 + column)],
                expected[std::size_t(row * 9000 + 8100 + column)]);
}

} // namespace
} // namespace firsthit::test
