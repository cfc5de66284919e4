// gpu_planes_test.cpp - the gpu engine's planes are the cpu engine's, within what float leaves.
#include "gl/gpu_pictures.h"

#include "lights.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

class GpuPlanes : public test::OnGpu {
  protected:
    void SetUp() override
    {
        OnGpu::SetUp();
        if (!context) return;
        load("builtin:robots", 1.5);
        settings.shadows = Shadows::map;
        settings.color = false;
        settings.aovs = {Aov::item, Aov::depth, Aov::distance, Aov::uv, Aov::normal,
            Aov::geometric_normal, Aov::position, Aov::albedo, Aov::barycentric, Aov::lit};
        render_both("planes");
    }

    /// Values that differ by more than `tolerance`, a share of all.
    double different(Aov aov, float tolerance)
    {
        const std::vector<float>&a = gpu_film[aov].value, &b = cpu_film[aov].value;
        EXPECT_FALSE(a.empty());
        return double(test::count_different(a, b, tolerance)) / double(a.size());
    }
};

TEST_F(GpuPlanes, HaveTheSameItems)
{
    EXPECT_EQ(gpu_film.item, cpu_film.item);
}

TEST_F(GpuPlanes, HaveDepthsToAMillimetre)
{
    // Of 40 metres. Where the floor is seen at a grazing angle, float's roundings count most.
    for (const Aov aov : {Aov::depth, Aov::distance, Aov::position}) {
        EXPECT_EQ(different(aov, 1e-3f), 0);
        EXPECT_LE(different(aov, 1e-5f), 0.1);
    }
}

TEST_F(GpuPlanes, HaveWeightsToAThousandth)
{
    // A thousandth of a triangle that is a pixel large is a thousandth of a pixel.
    EXPECT_LE(different(Aov::barycentric, 1e-3f), 1e-3);
    EXPECT_LE(different(Aov::uv, 1e-3f), 1e-3);
}

TEST_F(GpuPlanes, HaveTheSameNormals)
{
    EXPECT_LE(different(Aov::geometric_normal, 1e-5f), 1e-4);
    EXPECT_LE(different(Aov::normal, 1e-3f), 1e-3);
}

TEST_F(GpuPlanes, HaveTheSameTexelColors)
{
    EXPECT_LE(different(Aov::albedo, 1.0f / 255), 1e-3);
}

TEST_F(GpuPlanes, SayOfEachLightHowMuchArrives)
{
    EXPECT_EQ(gpu_film[Aov::lit].channels, 2);
    EXPECT_LE(different(Aov::lit, 0), 1e-3);
}

TEST_F(GpuPlanes, AreOfEveryPixelWherePicturesAreInterleaved)
{
    settings.color = true;
    settings.interleave = 4;
    settings.aovs = {Aov::item};
    gl::GpuFrame frame(*context);
    render_gpu(frame);
    EXPECT_EQ(gpu_film.item, cpu_film.item);
}

} // namespace
} // namespace firsthit
