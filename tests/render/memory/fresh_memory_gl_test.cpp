// fresh_memory_gl_test.cpp - pictures of the OpenGL engines do not depend on what memory held
// before.
#include "render/memory/fresh_memory.h"
#include "render/memory/memory_cases.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

/// All quick cases in all ways, by one renderer: contexts are slow to make. Its memory grows with
/// the pictures; what has grown already holds what other pictures left there.
std::vector<std::vector<std::byte>> pictures(Engine engine, FreshFill fill, int tile_size)
{
    const FreshMemory fresh(fill);
    Renderer renderer(2);
    std::vector<std::vector<std::byte>> made;
    const std::vector<MemoryCase> cases = memory_cases();
    for (const FrameKind& kind : frame_kinds(engine))
        for (std::size_t k = kQuickCases; k-- > 0;) {
            Settings settings = kind.settings;
            settings.tile_size = tile_size;
            Film film;
            renderer.render(cases[k].made.world.world, cases[k].made.view, settings, film);
            made.push_back(bytes_of(film));
        }
    return made;
}

class FreshMemoryOnOpenGl : public testing::TestWithParam<Engine> {};

TEST_P(FreshMemoryOnOpenGl, DecidesNoPicture)
{
    std::vector<std::vector<std::byte>> expected;
    try {
        expected = pictures(GetParam(), FreshFill::zeros, 64);
    } catch (const DeviceError& error) {
        GTEST_SKIP() << error.what();
    }
    const std::vector<FrameKind> kinds = frame_kinds(GetParam());
    for (const FreshFill fill : {FreshFill::ones, FreshFill::one, FreshFill::random}) {
        const auto made = pictures(GetParam(), fill, 32);
        ASSERT_EQ(made.size(), expected.size());
        for (std::size_t k = 0; k < made.size(); ++k)
            EXPECT_TRUE(made[k] == expected[k])
                << kinds[k / kQuickCases].name << ", case " << kQuickCases - 1 - k % kQuickCases
                << ", fill " << int(fill);
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, FreshMemoryOnOpenGl, testing::Values(Engine::hybrid, Engine::gpu),
    [](const auto& instance) {
        return instance.param == Engine::hybrid ? std::string("hybrid") : std::string("gpu");
    });

} // namespace
} // namespace firsthit::test
