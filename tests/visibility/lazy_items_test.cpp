// lazy_items_test.cpp - listed samples get the brute-force ray caster's items, bit for bit.
#include "visibility/lazy_items.h"
#include "cpu/adversarial_scenes.h"
#include "items.h"

#include <random>

namespace firsthit::test {
namespace {

using Samples = std::vector<ListedSample>;

std::vector<std::uint32_t> listed_items(
    const EyeWorld& eye, const Samples& samples, int threads = 1)
{
    Tasks tasks(threads);
    LazyMemory memory;
    const std::span<const std::uint32_t> items =
        find_listed_items(eye.memory.pencil, eye.memory, {samples}, memory, tasks);
    return {items.begin(), items.end()};
}

std::vector<std::uint32_t> brute_items_of(const EyeWorld& eye, const Samples& samples)
{
    Effort effort;
    std::vector<std::uint32_t> items;
    for (const ListedSample& s : samples)
        items.push_back(cast_brute(eye.triangles, eye.ray(s.x, s.y), effort));
    return items;
}

Samples random_samples(const View& view, std::size_t count, std::mt19937& random)
{
    Samples samples;
    while (samples.size() < count)
        samples.push_back({std::uint16_t(random() % unsigned(view.width)),
            std::uint16_t(random() % unsigned(view.height))});
    return samples;
}

class LazyItems : public testing::TestWithParam<std::size_t> {
  protected:
    template <class F>
    void for_worlds(const F& check)
    {
        for (unsigned round = 0; round < 4; ++round) {
            SCOPED_TRACE(adversarial_scenes()[GetParam()].name + ", seed " + std::to_string(round));
            std::mt19937 random(round);
            TestWorld world;
            adversarial_scenes()[GetParam()].fill(world, random);
            world.finish();
            check(EyeWorld(world.world, view), random);
        }
    }

    const View view = straight_view(kSize, kSize, kSize);
};

TEST_P(LazyItems, EqualBruteForce)
{
    for_worlds([&](const EyeWorld& eye, std::mt19937& random) {
        for (const std::size_t count : {1u, 20u, 3000u}) { // 3000: nearly all, and many twice
            const Samples samples = random_samples(view, count, random);
            EXPECT_EQ(differences(listed_items(eye, samples), brute_items_of(eye, samples), 1), 0u);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Adversarial, LazyItems,
    testing::Range(std::size_t(0), adversarial_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        std::string name = adversarial_scenes()[scene.param].name;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

/// More triangles than one task takes, across a picture of several words of bins.
struct WideWorld {
    TestWorld world;
    View view = straight_view(1301, 43, 900);
    std::mt19937 random{5};

    WideWorld()
    {
        const auto uniform = [&](float low, float high) {
            return std::uniform_real_distribution<float>(low, high)(random);
        };
        for (int k = 0; k < 15000; ++k) {
            const float z = uniform(1, 9), size = k % 100 ? 0.02f : 1.0f;
            const glm::vec3 p{uniform(-.8f, .8f) * z, uniform(-.03f, .03f) * z, z};
            const auto near_p = [&] {
                return p + size * glm::vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            };
            world.add(near_p(), near_p(), near_p());
        }
        for (std::size_t k = 0; k < 15000; k += 3) // equal depths far from each other in the list
            world.scene->index.push_back(world.scene->index[k]);
        world.finish();
    }
};

TEST(LazyItemsOfAWidePicture, EqualBruteForceForAnyNumberOfThreads)
{
    WideWorld wide;
    EyeWorld eye(wide.world.world, wide.view);
    Samples samples = random_samples(wide.view, 300, wide.random);
    for (const int x : {0, 511, 512, 1023, 1024, 1300}) // at the ends of bins and of words
        for (const int y : {0, 7, 8, 42}) samples.push_back({std::uint16_t(x), std::uint16_t(y)});
    const auto expected = brute_items_of(eye, samples);
    EXPECT_GT(std::count_if(expected.begin(), expected.end(),
                  [](std::uint32_t item) { return item != kNoItem; }),
        100);
    for (const int threads : {1, 2, 7})
        EXPECT_EQ(differences(listed_items(eye, samples, threads), expected, 1), 0u) << threads;
}

TEST(LazyItemsOfNothing, AreNone)
{
    TestWorld world;
    world.finish();
    EyeWorld eye(world.world, straight_view(9, 9, 9));
    EXPECT_TRUE(listed_items(eye, {}).empty());
    EXPECT_EQ(listed_items(eye, {{8, 8}}), std::vector<std::uint32_t>{kNoItem});
}

} // namespace
} // namespace firsthit::test
