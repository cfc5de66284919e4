// item_buffer_test.cpp - the item buffer is the brute-force ray caster, bit for bit.
#include "cpu/adversarial_scenes.h"
#include "instruction_sets.h"
#include "items.h"

namespace firsthit::test {
namespace {

class ItemBuffer : public testing::TestWithParam<std::size_t> {
  protected:
    static constexpr int kRounds = 6;

    template <class F>
    void for_worlds(const F& check)
    {
        const AdversarialScene& scene = adversarial_scenes()[GetParam()];
        for (unsigned round = 0; round < kRounds; ++round) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(round));
            std::mt19937 random(round);
            TestWorld world;
            scene.fill(world, random);
            world.finish();
            check(world, random);
        }
    }

    const View view = straight_view(kSize, kSize, kSize);
};

TEST_P(ItemBuffer, EqualsBruteForce)
{
    for_worlds([&](TestWorld& world, std::mt19937&) {
        EXPECT_EQ(
            differences(items_of(world.world, view), brute_items(world.world, view), kSize), 0u);
    });
}

/// Orthographic cameras before, within and beside the triangles.
TEST_P(ItemBuffer, OfParallelRaysEqualsBruteForce)
{
    for_worlds([&](TestWorld& world, std::mt19937&) {
        for (const glm::dvec3& eye : {glm::dvec3(0, 0, -3), {0, 0, 1}, {0.25, 0.125, 1.0 / 3}}) {
            View parallel = view;
            parallel.camera.eye = eye;
            parallel.camera.orthographic_height = eye.z < 1 ? 1.0 : 2.7;
            if (eye.x != 0) parallel.camera.direction = {0.3, -0.2, 1};
            const auto items = items_of(world.world, parallel);
            EXPECT_EQ(differences(items, brute_items(world.world, parallel), kSize), 0u);
            EXPECT_EQ(items_of(world.world, parallel, 7, 24), items);
        }
    });
}

TEST_P(ItemBuffer, IsTheSameForEveryThreadCountAndTileSize)
{
    for_worlds([&](TestWorld& world, std::mt19937&) {
        const auto expected = items_of(world.world, view);
        for (const int threads : {2, 7, 64})
            EXPECT_EQ(items_of(world.world, view, threads), expected);
        for (const int tile : {8, 16, 24, 32, 40, 128})
            EXPECT_EQ(items_of(world.world, view, 1, tile), expected) << "tile size " << tile;
    });
}

TEST_P(ItemBuffer, IsTheSameForEveryInstructionSet)
{
    for_worlds([&](TestWorld& world, std::mt19937&) {
        const auto expected = items_of(world.world, view);
        for_instruction_sets([&] { EXPECT_EQ(items_of(world.world, view), expected); });
    });
}

TEST_P(ItemBuffer, FollowsTheTrianglesWhenTheirOrderChanges)
{
    for_worlds([&](TestWorld& world, std::mt19937& random) {
        std::vector<glm::uvec3>& index = world.scene->index;
        std::vector<std::uint32_t> order(index.size());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = std::uint32_t(k);
        std::shuffle(order.begin(), order.end(), random);
        const std::vector<glm::uvec3> original = index;
        for (std::size_t k = 0; k < order.size(); ++k) {
            glm::uvec3 corner = original[order[k]];
            if (random() & 1) std::swap(corner.x, corner.z); // the winding does not matter
            if (random() & 1) corner = {corner.y, corner.z, corner.x};
            index[k] = corner;
        }
        EXPECT_EQ(
            differences(items_of(world.world, view), brute_items(world.world, view), kSize), 0u);
    });
}

TEST_P(ItemBuffer, OfARegionIsARegionOfTheItemBuffer)
{
    for_worlds([&](TestWorld& world, std::mt19937& random) {
        const auto whole = items_of(world.world, view);
        View part = view;
        part.region.x = int(random() % 30), part.region.y = int(random() % 30);
        part.region.width = 1 + int(random() % 18), part.region.height = 1 + int(random() % 18);
        const auto items = items_of(world.world, part, 1, 16);
        for (int y = 0; y < part.region.height; ++y)
            for (int x = 0; x < part.region.width; ++x)
                ASSERT_EQ(items[std::size_t(y * part.region.width + x)],
                    whole[std::size_t((y + part.region.y) * kSize + x + part.region.x)]);
    });
}

TEST(FrameMemoryOfItems, CarriesNothingFromFrameToFrame)
{
    // Triangles 0 and 1 lie in one plane at first; then 1 is nearer by less than the float filter
    // can tell, so that what was known of the pair would be wrong.
    Tasks tasks(1);
    FrameMemory memory;
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    const View view = checked(straight_view(kSize, kSize, kSize));
    for (const float z : {4.0f, 4.0f * (1 - 0x1p-22f), 4.0f}) {
        TestWorld world;
        world.add({-9, -9, 4}, {9, -9, 4}, {0, 9, 4});
        world.add({-9, -9, z}, {9, -9, z}, {0, 9, z});
        world.finish();
        Film film;
        Stats stats;
        render_frame({world.world, view, tasks, film}, settings, memory, stats);
        EXPECT_EQ(film.item, brute_items(world.world, view)) << z;
        EXPECT_EQ(film.item[kSize * kSize / 2], z < 4 ? 1u : 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Adversarial, ItemBuffer,
    testing::Range(std::size_t(0), adversarial_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        std::string name = adversarial_scenes()[scene.param].name;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

} // namespace
} // namespace firsthit::test
