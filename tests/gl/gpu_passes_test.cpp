// gpu_passes_test.cpp - several passes make the same picture as one, and masked samples cost
// nothing.
#include "gl/gpu_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit {
namespace {

using GpuPasses = test::OnGpu;

std::uint64_t hits_of(const std::vector<std::uint32_t>& item)
{
    return std::uint64_t(
        std::count_if(item.begin(), item.end(), [](std::uint32_t id) { return id != kNoItem; }));
}

TEST_F(GpuPasses, SeveralMakeTheSamePictureAsOne)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::map;
    gl::GpuFrame frame(*context);
    for (const Multisample multisample : {Multisample::none, Multisample::lazy3, Multisample::lazy5,
             Multisample::full3, Multisample::full5, Multisample::exact}) {
        for (const int every : {1, 8}) {
            settings.multisample = multisample;
            settings.interleave = every;
            settings.opengl.passes = firsthit::GpuPasses::single;
            render_gpu(frame);
            const Film single = gpu_film;
            settings.opengl.passes = firsthit::GpuPasses::multi;
            render_gpu(frame);
            EXPECT_TRUE(gpu_film.color.value == single.color.value)
                << int(multisample) << " " << every << " different "
                << test::count_different(gpu_film.color.value, single.color.value, 0) << " "
                << test::count_different(gpu_film.color.value, single.color.value, 1e-5f) << " "
                << test::count_different(gpu_film.color.value, single.color.value, 1e-3f);
        }
    }
}

TEST_F(GpuPasses, KeepABoundedNumberOfPrograms)
{
    load("builtin:torus", 0, 32);
    world.lights = {Light{.position = {5, 5, 5}}};
    gl::GpuFrame frame(*context);
    settings.shadows = Shadows::map;
    settings.multisample = Multisample::none;
    render_gpu(frame);
    const Film first = gpu_film;
    const std::int64_t before = gl::gl_objects_alive();

    // Each plane needs its own program for each hit test and for each number of lights.
    int asked = 0;
    for (const Shadows shadows : {Shadows::none, Shadows::map})
        for (const auto passes : {firsthit::GpuPasses::single, firsthit::GpuPasses::multi})
            for (const Multisample multisample :
                {Multisample::none, Multisample::lazy3, Multisample::full3, Multisample::exact}) {
                settings.shadows = shadows;
                settings.multisample = multisample;
                settings.opengl.passes = passes;
                settings.aovs = {Aov::item, Aov::depth, Aov::distance, Aov::uv, Aov::normal,
                    Aov::geometric_normal, Aov::position, Aov::albedo, Aov::barycentric};
                asked += int(settings.aovs.size());
                render_gpu(frame);
            }
    ASSERT_GT(asked, int(gl::SamplePasses::kMostPrograms));
    // The other objects are few: one of each kind of plane.
    EXPECT_LE(gl::gl_objects_alive(), before + int(gl::SamplePasses::kMostPrograms) + 8);

    // Programs that were deleted are linked again.
    settings.shadows = Shadows::map;
    settings.multisample = Multisample::none;
    settings.opengl.passes = firsthit::GpuPasses::single;
    settings.aovs = {};
    render_gpu(frame);
    EXPECT_TRUE(gpu_film.color.value == first.color.value);
}

TEST_F(GpuPasses, RunNoShaderForMaskedSamples)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    settings.opengl.passes = firsthit::GpuPasses::multi;
    gl::GpuFrame frame(*context, {.count_invocations = true});
    render_gpu(frame);
    // One intersection and one shading for each sample with an item.
    EXPECT_EQ(frame.passes().take_invocations(), 2 * hits_of(item));
    EXPECT_LT(hits_of(item), item.size());
}

TEST_F(GpuPasses, RunTheSingleShaderForEverySample)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    gl::GpuFrame frame(*context, {.count_invocations = true});
    render_gpu(frame);
    EXPECT_EQ(frame.passes().take_invocations(), item.size());
}

TEST_F(GpuPasses, ShootOnlyWhereInterleavingSays)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    settings.interleave = 4;
    settings.opengl.passes = firsthit::GpuPasses::multi;
    gl::GpuFrame frame(*context, {.count_invocations = true});
    render_gpu(frame);
    const auto share = double(frame.passes().take_invocations()) / double(2 * hits_of(item));
    EXPECT_NEAR(share, 0.25, 0.01);
}

TEST_F(GpuPasses, FindTheNeighbourWhereTheItemIsWrong)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    settings.aovs = {Aov::item};
    gl::GpuFrame frame(*context);
    const std::vector<std::uint32_t> right = test::cpu_items(world, view);
    // Each sample of every third column gets the item of its left neighbour.
    change_items = [&](std::vector<std::uint32_t>& drawn) {
        for (std::size_t k = 2; k < drawn.size(); k += 3) drawn[k] = right[k - 1];
    };
    const auto wrong = [&](Multisample multisample) {
        settings.multisample = multisample;
        render_gpu(frame);
        std::size_t count = 0;
        for (std::size_t k = 0; k < right.size(); ++k) count += gpu_film.item[k] != right[k];
        return count;
    };
    const std::size_t missed = wrong(Multisample::none);
    EXPECT_GT(missed, 1000u);
    EXPECT_LT(wrong(Multisample::lazy3), missed / 10);
    EXPECT_LT(wrong(Multisample::full5), missed / 50);
}

TEST_F(GpuPasses, CountHitsMissesAndWhatIsInterpolated)
{
    load("builtin:torus", 0, 128);
    settings.shadows = Shadows::none;
    settings.multisample = Multisample::none;
    change_items = [](std::vector<std::uint32_t>& drawn) {
        for (std::size_t k = 64 * 128 + 20; k < 64 * 128 + 30; ++k) drawn[k] = 0; // not hit there
    };
    gl::GpuFrame frame(*context);
    for (const auto passes : {firsthit::GpuPasses::single, firsthit::GpuPasses::multi}) {
        settings.opengl.passes = passes;
        settings.interleave = 1;
        render_gpu(frame);
        // Besides these ten, rounding loses a few samples at edges.
        EXPECT_NEAR(double(stats.missed), 10, 5);
        EXPECT_EQ(stats.hits + stats.missed, hits_of(item));
        EXPECT_EQ(stats.interpolated, stats.missed);
        settings.interleave = 4;
        render_gpu(frame);
        EXPECT_EQ(stats.interpolated, 128u * 128 * 3 / 4 + stats.missed);
    }
    settings.interleave = 1;
    settings.samples = 2;
    settings.multisample = Multisample::exact;
    change_items = {};
    render_gpu(frame);
    EXPECT_EQ(stats.hits, hits_of(item));
    EXPECT_EQ(stats.missed, 0u);
    settings.samples = 1;
    settings.color = false;
    render_gpu(frame);
    EXPECT_EQ(stats.hits, hits_of(item));
}

} // namespace
} // namespace firsthit
