// certified_items_test.cpp - compares the items of unmarked samples with those of the cpu engine.
#include "gl/items/certified_items.h"

#include "../cpu/adversarial_scenes.h"
#include "gl_context.h"
#include "items.h"
#include "scene/model/borrow.h"
#include "scenes.h"
#include "visibility/lazy_items.h"

#include <vector>

namespace firsthit {
namespace {

using CertifiedItems = test::OnContext;

struct Counts {
    std::size_t wrong = 0;       // not marked, and not the exact item
    std::size_t repaired = 0;    // wrong before the marked ones were decided
    std::size_t wrong_after = 0; // wrong afterwards
    double marked = 0;           // share of all samples
};

Counts count(const gl::Context& context, const World& world, const View& view)
{
    const test::EyeWorld eye(world, view);
    const Pencil& pencil = eye.memory.pencil;
    const auto width = std::size_t(pencil.width), height = std::size_t(pencil.height);
    gl::SceneBuffers scene(context, gl::Detail::items);
    scene.lend_eye_space(world, pencil, eye.memory.corner.span());
    gl::CertifiedItems pass(context);
    pass.draw(scene, pencil, eye.memory.cutouts);
    std::vector<std::uint32_t> items(width * height);
    pass.read_items(items);
    std::vector<bool> marks(width * height);
    const std::span<const ListedSample> listed = pass.read_uncertain();
    for (const ListedSample& at : listed) marks[at.y * width + at.x] = true;

    const std::vector<std::uint32_t> expected = test::items_of(world, view);
    Counts counts;
    for (std::size_t k = 0; k < items.size(); ++k) {
        if (marks[k]) {
            counts.repaired += items[k] != expected[k];
        } else if (items[k] != expected[k] && ++counts.wrong < 6) {
            ADD_FAILURE() << "sample (" << k % width << ", " << k / width << "): " << items[k]
                          << ", exact " << expected[k];
        }
    }
    EyeMesh mesh;
    take_triangles(*world.scene, mesh);
    Tasks tasks(1);
    project_vertices(world.position, pencil, mesh, tasks);
    LazyMemory lazy;
    pass.write(listed, find_listed_items(pencil, mesh, {listed}, lazy, tasks));
    pass.read_items(items);
    for (std::size_t k = 0; k < items.size(); ++k) counts.wrong_after += items[k] != expected[k];
    counts.marked = double(listed.size()) / double(items.size());
    return counts;
}

void expect_scene(const gl::Context& context, const std::string& name, double time, double marked)
{
    const Scene scene = load_scene(name);
    World world;
    pose(borrow(scene), time, world);
    const Counts counts = count(context, world, {world.camera, 512, 512, {}});
    EXPECT_EQ(counts.wrong, 0u);
    EXPECT_EQ(counts.wrong_after, 0u);
    EXPECT_LT(counts.marked, marked);
    testing::Test::RecordProperty("marked", std::to_string(counts.marked));
}

TEST_F(CertifiedItems, AreExactForTheTorus)
{
    expect_scene(*context, "builtin:torus", 0, 0.001);
}

TEST_F(CertifiedItems, AreExactForTheRobots)
{
    expect_scene(*context, "builtin:robots", 2.5, 0.005);
}

TEST_F(CertifiedItems, AreExactForAWaveOf100000Triangles)
{
    expect_scene(*context, "builtin:wave?n=100000", 0.5, 0.02);
}

TEST_F(CertifiedItems, AreExactForScenesThatBreakRasterisers)
{
    for (const test::AdversarialScene& scene : test::adversarial_scenes()) {
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            test::TestWorld made;
            scene.fill(made, random);
            const Counts counts = count(*context, made.finish(),
                test::straight_view(test::kSize, test::kSize, test::kSize));
            EXPECT_EQ(counts.wrong, 0u);
            EXPECT_EQ(counts.wrong_after, 0u);
        }
    }
}

float uniform(std::mt19937& random, float low, float high)
{
    return std::uniform_real_distribution<float>(low, high)(random);
}

/// The point of eye space that is seen in the direction (x, y), in the world of a straight_view.
glm::vec3 seen_at(float x, float y, float z, float f)
{
    return {x / f * z, y / f * z, z};
}

void expect_exact(const gl::Context& context, test::TestWorld& made, const View& view)
{
    const Counts counts = count(context, made.finish(), view);
    EXPECT_EQ(counts.wrong, 0u);
    EXPECT_EQ(counts.wrong_after, 0u);
}

TEST_F(CertifiedItems, AreExactWhereACornerIsSoFarThatProductsOverflow)
{
    std::mt19937 random(1);
    const auto seen = [&](float z) {
        return seen_at(uniform(random, -24, 24), uniform(random, -24, 24), z, test::kSize);
    };
    test::TestWorld made;
    for (int k = 0; k < 30; ++k) {
        const float far = std::pow(10.0f, uniform(random, 18, 26));
        made.add(seen(1), seen(1), {uniform(random, -1, 1), far * uniform(random, -1, 1), far});
    }
    expect_exact(*context, made, test::straight_view(test::kSize, test::kSize, test::kSize));
}

TEST_F(CertifiedItems, AreExactForScenesSoSmallThatProductsUnderflow)
{
    constexpr int kWide = 60000; // nearly all of it behind the picture's edges
    constexpr float kFocal = 9;
    View view = test::straight_view(kWide, kWide, kFocal);
    view.region = {14000, 1, 12, 29};
    const glm::vec2 middle(14006 - kWide / 2, 15 - kWide / 2);
    for (int k = 0; k < 40; ++k) {
        SCOPED_TRACE(k);
        std::mt19937 random(static_cast<unsigned>(k));
        const float scale = std::pow(10.0f, uniform(random, -18, -13));
        test::TestWorld made;
        for (int t = 0; t < 40; ++t) {
            const float z = scale * uniform(random, 1, 2);
            const auto seen = [&] {
                return seen_at(middle.x + uniform(random, -8, 8),
                    middle.y + uniform(random, -17, 17), z, kFocal);
            };
            made.add(seen(), seen(), seen());
        }
        expect_exact(*context, made, view);
    }
}

TEST_F(CertifiedItems, AreExactWhereACornerIsSoNearThatItIsFlushedToZero)
{
    constexpr int kWide = 60000; // rays that are far from the axis make much of what is lost
    View view = test::straight_view(kWide, kWide, kWide);
    view.region = {kWide - 40, kWide - 40, 40, 40};
    std::mt19937 random(3);
    const auto seen = [&](float z) {
        const float edge = kWide / 2;
        return seen_at(edge + uniform(random, -42, 2), edge + uniform(random, -42, 2), z, kWide);
    };
    for (int k = 0; k < 20; ++k) {
        SCOPED_TRACE(k);
        test::TestWorld made;
        for (int t = 0; t < 6; ++t) {
            const float tiny = uniform(random, 0, 1.1e-38f), big = std::pow(10.0f, float(t));
            glm::vec3 at_eye = seen(1);
            at_eye.x *= uniform(random, 0.3f, 1.7f) * tiny;
            at_eye.y *= uniform(random, 0.3f, 1.7f) * tiny;
            at_eye.z = tiny;
            made.add(at_eye, seen(big), seen(big * uniform(random, 0.5f, 2)));
        }
        expect_exact(*context, made, view);
    }
}

} // namespace
} // namespace firsthit
