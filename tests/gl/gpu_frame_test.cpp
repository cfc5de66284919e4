// gpu_frame_test.cpp - with the same items and maps, the gpu engine makes the same pictures as the
// cpu engine.
#include "gl/gpu_pictures.h"

#include "gl/items/drawn_items.h"

#include "lights.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

using GpuFrame = test::OnGpu;

/// Least PSNR, in decibels, of pictures without and with textures.
constexpr double kPlain = 60, kTextured = 45;

TEST_F(GpuFrame, ShadesATorusAsTheCpuDoes)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    render_both("torus");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kPlain);
}

TEST_F(GpuFrame, ShadesTexturedRobotsInShadowAsTheCpuDoes)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::map;
    render_both("robots");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kTextured);
}

TEST_F(GpuFrame, FiltersShadowsAsTheCpuDoes)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::map;
    settings.shadow_filter = 3;
    render_both("robots_filter3");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kTextured);
}

TEST_F(GpuFrame, KeepsToAGivenShadowBias)
{
    load("builtin:torus");
    settings.shadows = Shadows::map;
    settings.shadow_bias = 0.02;
    render_both("torus_bias");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kPlain);
}

/// Scenes with a single light.
class GpuLights : public test::OnGpu {
  protected:
    void expect_same(const std::string& scene_name, const Light& light, double least)
    {
        load(scene_name);
        scene.lights = {light};
        pose_at(0);
        settings.shadows = Shadows::map;
        for (const int filter : {1, 3}) {
            settings.shadow_filter = filter;
            const auto* test = testing::UnitTest::GetInstance()->current_test_info();
            render_both(std::string(test->name()) + std::to_string(filter));
            EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), least) << filter;
        }
    }
};

TEST_F(GpuLights, ShineFromAPointToAllSides)
{
    expect_same("builtin:torus", test::point_light({0.1, 0.2, 0.1}), kPlain);
}

TEST_F(GpuLights, ShineFromAPointAmongRobots)
{
    expect_same("builtin:robots", test::point_light({2.5, 3, 1.5}), kTextured);
}

TEST_F(GpuLights, ShineInParallel)
{
    expect_same("builtin:torus", test::directional_light({-1, -2, -0.5}), kPlain);
}

TEST_F(GpuLights, ShineInParallelOnRobots)
{
    expect_same("builtin:robots", test::directional_light({-1, -1, -0.5}), kTextured);
}

TEST_F(GpuLights, ShineIntoACone)
{
    expect_same("builtin:torus", test::spot_light({1, 4, 2}, {-0.2, -1, -0.5}, 0.35, 0.5), kPlain);
}

TEST_F(GpuLights, ShineIntoAConeOnRobots)
{
    expect_same(
        "builtin:robots", test::spot_light({5, 8, 4}, {-0.6, -1, -0.5}, 0.5, 0.5), kTextured);
}

TEST_F(GpuLights, ShineIntoAConeTooWideForOneMap)
{
    expect_same(
        "builtin:robots", test::spot_light({0.5, 5, 0.5}, {-0.2, -1, -0.1}, 1.4), kTextured);
}

TEST_F(GpuFrame, AveragesSamples)
{
    load("builtin:torus", 0, 100);
    settings.shadows = Shadows::none;
    settings.samples = 3;
    render_both("torus_samples3");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kPlain);
}

TEST_F(GpuFrame, InterleavesAsTheCpuDoes)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::none;
    for (const int every : {2, 4, 8, 16}) {
        settings.interleave = every;
        render_both("robots_interleave" + std::to_string(every));
        EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kTextured) << every;
    }
}

TEST_F(GpuFrame, RendersARegionOfThePicture)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::none;
    settings.interleave = 4;
    view.region = {.x = 37, .y = 51, .width = 91, .height = 67};
    render_both("robots_region");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kTextured);
}

TEST_F(GpuFrame, DrawsItemsInEveryFormat)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::none;
    settings.multisample = Multisample::lazy3;
    const test::CpuPicture cpu(world, view, settings);
    gl::GpuFrame frame(*context);
    gl::DrawnItems drawn(*context);
    for (const ItemFormat format : {ItemFormat::r32ui, ItemFormat::rgb8, ItemFormat::rgba8})
        for (const DepthFormat depth : {DepthFormat::float32, DepthFormat::fixed24}) {
            settings.opengl.item_format = format;
            settings.opengl.depth_format = depth;
            render_gpu(frame, gpu_film, {drawn});
            test::keep(gpu_film, "robots_drawn");
            // A few pixels at edges see other triangles.
            EXPECT_GE(test::psnr(gpu_film.color.value, cpu.film.color.value), 35)
                << int(format) << " " << int(depth);
        }
}

TEST_F(GpuFrame, DrawsShadowMapsThatShadeAsTheCpusDo)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::map;
    const test::CpuPicture cpu(world, view, settings);
    gl::GpuFrame frame(*context);
    render_gpu(frame);
    test::keep(gpu_film, "robots_maps");
    // Texels at the edges of occluders differ.
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu.film.color.value), 35);
}

TEST_F(GpuFrame, MakesLargePicturesInSections)
{
    load("builtin:robots", 1.5, 200);
    settings.shadows = Shadows::none;
    settings.samples = 2;
    settings.multisample = Multisample::lazy3;
    gl::GpuFrame whole(*context), sections(*context, {.section_side = 130});
    gl::DrawnItems drawn(*context);
    render_gpu(whole, cpu_film, {drawn});
    render_gpu(sections, gpu_film, {drawn});
    // Edges are snapped relative to the section.
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 40);
}

TEST_F(GpuFrame, ShadesMoreLightsThanUniformBlocksHold)
{
    load("builtin:torus");
    scene.lights.clear();
    for (int k = 0; k < 40; ++k) {
        scene.lights.push_back(test::directional_light({k - 20, -30, k % 7}));
        scene.lights.back().color = glm::vec3(0.05f);
    }
    pose_at(0);
    settings.shadows = Shadows::map;
    settings.shadow_map_size = 64;
    render_both("torus_lights40");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), kPlain);
}

TEST_F(GpuFrame, ShowsTheBackgroundOfAnEmptyScene)
{
    scene.background = {0.25f, 0.5f, 0.75f};
    scene.lights = {test::point_light({1, 2, 3})};
    pose_at(0);
    view.width = view.height = 20;
    settings.shadows = Shadows::map;
    for (const auto passes : {GpuPasses::single, GpuPasses::multi}) {
        settings.opengl.passes = passes;
        gl::GpuFrame frame(*context);
        gl::DrawnItems drawn(*context);
        render_gpu(frame, gpu_film, {drawn});
        for (std::size_t k = 0; k < gpu_film.color.value.size(); ++k)
            ASSERT_EQ(gpu_film.color.value[k], scene.background[int(k % 3)]);
    }
}

TEST_F(GpuFrame, ShowsHolesWhereTheyAreNotToBeFilled)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    settings.multisample = Multisample::none;
    settings.interpolate = false;
    scene.background = {0, 1, 0};
    change_items = [](std::vector<std::uint32_t>& drawn) {
        for (std::uint32_t& id : drawn)
            if (id != kNoItem) id = 0; // which nearly no sample hits
    };
    gl::GpuFrame frame(*context);
    render_gpu(frame);
    const std::size_t middle = (128 * 256 + 30) * 3;
    EXPECT_NE(item[middle / 3], kNoItem);
    EXPECT_EQ(gpu_film.color.value[middle + 1], 1);
}

TEST_F(GpuFrame, MakesNothingMoreOnceSizesHaveSettled)
{
    load("builtin:robots");
    settings.shadows = Shadows::map;
    settings.aovs = {Aov::item, Aov::depth, Aov::uv, Aov::normal, Aov::lit};
    settings.shadow_map_size = 256;
    gl::GpuFrame frame(*context);
    render_gpu(frame);
    pose_at(0.5);
    render_gpu(frame);
    const std::int64_t alive = gl::gl_objects_alive();
    for (int k = 0; k < 3; ++k) {
        pose_at(1 + k);
        render_gpu(frame);
    }
    EXPECT_EQ(gl::gl_objects_alive(), alive);
}

} // namespace
} // namespace firsthit
