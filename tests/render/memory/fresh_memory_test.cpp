// fresh_memory_test.cpp - pictures of the cpu engine do not depend on what memory held before.
#include "instruction_sets.h"
#include "render/memory/fresh_memory.h"
#include "render/memory/memory_cases.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

std::vector<std::byte> picture(
    Renderer& renderer, const MemoryCase& shown, const FrameKind& kind, int tile_size)
{
    Settings settings = kind.settings;
    settings.tile_size = tile_size;
    Film film;
    renderer.render(shown.made.world.world, shown.made.view, settings, film);
    return bytes_of(film);
}

/// Renders with a new renderer, so that all its memory is new.
std::vector<std::byte> fresh_picture(
    const MemoryCase& shown, const FrameKind& kind, FreshFill fill, int tile_size, int threads)
{
    const FreshMemory fresh(fill);
    Renderer renderer(threads);
    return picture(renderer, shown, kind, tile_size);
}

TEST(FreshMemory, DecidesNoPicture)
{
    // A renderer that has made all other pictures before, whose values are still in its memory.
    Renderer used(2);
    for (const MemoryCase& shown : memory_cases()) {
        for (const FrameKind& kind : frame_kinds(Engine::cpu)) {
            SCOPED_TRACE(shown.name + ", " + kind.name);
            const auto expected = fresh_picture(shown, kind, FreshFill::zeros, 64, 1);
            struct Way {
                FreshFill fill;
                int tile_size, threads;
            };
            for (const Way& way : {Way{FreshFill::ones, 32, 2}, Way{FreshFill::one, 8, 1},
                     Way{FreshFill::random, 128, 3}})
                EXPECT_TRUE(
                    fresh_picture(shown, kind, way.fill, way.tile_size, way.threads) == expected)
                    << "fill " << int(way.fill) << ", tiles of " << way.tile_size;
            EXPECT_TRUE(picture(used, shown, kind, 16) == expected) << "in used memory";
        }
    }
}

TEST(FreshMemory, DecidesNoPictureOnAnyInstructionSet)
{
    const std::vector<MemoryCase> cases = memory_cases();
    for_instruction_sets([&] {
        for (std::size_t k = 0; k < kQuickCases; ++k)
            for (const FrameKind& kind : frame_kinds(Engine::cpu)) {
                SCOPED_TRACE(cases[k].name + ", " + kind.name);
                const auto expected = fresh_picture(cases[k], kind, FreshFill::zeros, 64, 1);
                for (const FreshFill fill : {FreshFill::nan, FreshFill::random})
                    EXPECT_TRUE(fresh_picture(cases[k], kind, fill, 64, 1) == expected)
                        << "fill " << int(fill);
            }
    });
}

TEST(FreshMemory, DecidesNoOcclusion)
{
    for (const ShadowScene& scene : shadow_scenes()) {
        SCOPED_TRACE(scene.name);
        const ShadowWorld made = make_shadow_world(scene, 5);
        const ShadowPoints points = shadow_points(made, 500, 11);
        const auto answers = [&](FreshFill fill, int threads) {
            const FreshMemory fresh(fill);
            Occlusion occlusion(threads);
            std::vector<std::uint8_t> bits;
            occlusion.test_packed(
                made.world.world, points.point, made.world.world.lights, bits, points.receiver);
            return bits;
        };
        const std::vector<std::uint8_t> expected = answers(FreshFill::zeros, 1);
        for (const FreshFill fill : kFreshFills)
            EXPECT_EQ(answers(fill, 2), expected) << "fill " << int(fill);
    }
}

} // namespace
} // namespace firsthit::test
