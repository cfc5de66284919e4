// certified_items_test.cpp - unmarked samples are proven: they are held against the cpu engine's.
#include "gl/certified_items.h"

#include "../cpu/adversarial_scenes.h"
#include "gl_context.h"
#include "items.h"
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
    pass.draw(scene, pencil);
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
    ViewMemory memory;
    memory.pencil = pencil;
    memory.index = world.scene->index;
    Tasks tasks(1);
    project_vertices(world.position, memory, tasks);
    LazyMemory lazy;
    std::vector<std::uint32_t> decided(listed.size());
    find_listed_items(memory, listed, lazy, decided, tasks);
    pass.write(listed, decided);
    pass.read_items(items);
    for (std::size_t k = 0; k < items.size(); ++k) counts.wrong_after += items[k] != expected[k];
    counts.marked = double(listed.size()) / double(items.size());
    return counts;
}

void expect_scene(const gl::Context& context, const std::string& name, double time, double marked)
{
    const Scene scene = load_scene(name);
    World world;
    pose(scene, time, world);
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

} // namespace
} // namespace firsthit
