// gpu_shadows_test.cpp - maps that OpenGL bounds and draws are those of the cpu engine.
#include "gl/gpu_pictures.h"

#include "lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace firsthit {
namespace {

class GpuShadows : public test::OnGpu {
  protected:
    /// Loads the robots with one light.
    void light(const Light& light)
    {
        load("builtin:robots", 1.5);
        scene.lights = {light};
        pose_at(1.5);
        settings.shadows = Shadows::map;
    }

    /// Of the only light: the rectangles that the hits fill lead to the same maps on both engines.
    /// Returns the share of texels that differ by more than a thousandth of their depth.
    double different_texels()
    {
        const test::CpuPicture cpu(world, view, settings);
        gl::GpuFrame frame(*context);
        render_gpu(frame);
        EXPECT_EQ(stats.map_updates, cpu.stats.map_updates);
        std::size_t texels = 0, different = 0;
        for (std::size_t face = 0; face < kFaces; ++face) {
            const ShadowMap& wanted = cpu.memory.lit.maps.light[0].map[face];
            ShadowMap map;
            map.source = frame.shadows().maps()[0].map[face].source;
            EXPECT_EQ(map.source.fit, wanted.source.fit) << face;
            if (map.source.fit != wanted.source.fit || map.width() == 0) continue;
            frame.shadows().texels().read(0, face, map);
            for (int y = 0; y < map.height(); ++y)
                for (int x = 0; x < map.width(); ++x) {
                    const float a = map.at(x, y), b = wanted.at(x, y);
                    different += !(a == b || std::abs(a - b) <= 1e-3f * std::abs(b));
                    ++texels;
                }
        }
        EXPECT_GT(texels, 0u);
        return double(different) / double(texels);
    }
};

// Edges of triangles are snapped to 1/256 of a texel.
constexpr double kFew = 0.005;

TEST_F(GpuShadows, AreOfALightFarAway)
{
    light(test::point_light({9, 16, 7}));
    EXPECT_LE(different_texels(), kFew);
}

TEST_F(GpuShadows, HaveSeveralFacesOfALightAmongRobots)
{
    light(test::point_light({2.5, 3, 1.5}));
    EXPECT_LE(different_texels(), kFew);
}

TEST_F(GpuShadows, HaveParallelRays)
{
    light(test::directional_light({-1, -1, -0.5}));
    EXPECT_LE(different_texels(), kFew);
}

TEST_F(GpuShadows, KeepToACone)
{
    light(test::spot_light({5, 8, 4}, {-0.6, -1, -0.5}, 0.5));
    EXPECT_LE(different_texels(), kFew);
}

TEST_F(GpuShadows, HaveTheSizeThatIsAskedFor)
{
    light(test::directional_light({-1, -1, -0.5}));
    settings.shadow_map_size = 700;
    EXPECT_LE(different_texels(), kFew);
}

TEST_F(GpuShadows, AreDrawnOnlyWhenSomethingHasChanged)
{
    light(test::directional_light({-1, -1, -0.5}));
    scene.lights.push_back(test::directional_light({1, -2, -0.5}));
    pose_at(1.5);
    gl::GpuFrame frame(*context);
    const auto updates = [&] {
        render_gpu(frame);
        return stats.map_updates;
    };
    EXPECT_EQ(updates(), 2u);
    EXPECT_EQ(updates(), 0u);
    scene.lights[1].color = glm::vec3(0.5f);
    pose_at(1.5);
    EXPECT_EQ(updates(), 0u);
    scene.lights[1].direction = {1, -2, -0.4};
    pose_at(1.5);
    EXPECT_EQ(updates(), 1u);
    pose_at(1.6);
    EXPECT_EQ(updates(), 2u);
}

TEST_F(GpuShadows, AreMadeAgainAfterMapsThatWereGiven)
{
    light(test::directional_light({-1, -1, -0.5}));
    const test::CpuPicture cpu(world, view, settings);
    gl::GpuFrame frame(*context);
    render_gpu(frame);
    const Film drawn = gpu_film;
    render_gpu(frame, &cpu.memory.lit.maps);
    render_gpu(frame);
    EXPECT_TRUE(gpu_film.color.value == drawn.color.value);
}

TEST_F(GpuShadows, ReportTheirSizeWhereMemoryIsTooSmall)
{
    light(test::point_light({2.5, 3, 1.5}));
    settings.shadow_map_size = 8192;
    gl::GpuFrame frame(*context);
    try {
        render_gpu(frame);
        ADD_FAILURE() << "five maps of 8192 texels fit into a buffer";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("smaller maps take less"), std::string::npos)
            << error.what();
    }
    settings.shadow_map_size = 0;
    render_gpu(frame); // as if nothing had been
    EXPECT_GT(stats.map_updates, 0u);
}

} // namespace
} // namespace firsthit
