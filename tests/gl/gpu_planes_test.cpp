// gpu_planes_test.cpp - the gpu engine's planes equal the cpu engine's up to rounding.
#include "gl/gpu_pictures.h"

#include "lights.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <random>

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

    /// The share of the values that differ by more than `tolerance`.
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
    // Depths are up to 40 metres. Rounding errors are largest where the floor is seen at a grazing
    // angle.
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

TEST_F(GpuPlanes, HaveTheVisibilityOfEachLight)
{
    EXPECT_EQ(gpu_film[Aov::lit].channels, 2);
    EXPECT_LE(different(Aov::lit, 0), 1e-3);
}

TEST_F(GpuPlanes, AreThoseOfACalibratedCamera)
{
    view.width = 200, view.height = 256;
    view.camera.focal = glm::dvec2(300.3, 210.7);
    view.camera.principal_point = glm::dvec2(81.37, 140.9);
    view.camera.skew = 21.5;
    render_both("calibrated");
    EXPECT_EQ(gpu_film.item, cpu_film.item);
    for (const Aov aov : {Aov::depth, Aov::distance, Aov::position})
        EXPECT_EQ(different(aov, 1e-3f), 0);
    EXPECT_LE(different(Aov::geometric_normal, 1e-5f), 1e-4);
    EXPECT_LE(different(Aov::normal, 1e-3f), 1e-3);
    EXPECT_LE(different(Aov::albedo, 1.0f / 255), 1e-3);
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

class GpuNearPlanes : public test::OnGpu {};

TEST_F(GpuNearPlanes, NormalsLookAtAnEyeThatIsNextToTheirPlane)
{
    if (!context) return;
    settings.color = false;
    settings.shadows = Shadows::none;
    settings.aovs = {Aov::item, Aov::geometric_normal};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    std::size_t hits = 0;
    for (int round = 0; round < 40; ++round) {
        // A triangle of some hundred metres, the eye a hundredth of a millimetre from it.
        const auto direction = [&] {
            return glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        };
        const glm::dvec3 n = direction(), along = glm::normalize(glm::cross(n, direction())),
                         across = glm::cross(n, along);
        const glm::dvec3 middle = 10.0 * direction();
        test::TestWorld triangle;
        triangle.add(middle - 200.0 * along - 150.0 * across,
            middle + 220.0 * along - 130.0 * across, middle + 180.0 * across);
        world = triangle.finish();
        view.width = view.height = 32;
        const double side = round % 2 ? 1 : -1;
        view.camera = {
            .eye = middle + side * 1e-5 * n, .direction = along - side * 0.001 * n, .up = n};
        gl::GpuFrame frame(*context);
        const test::CpuPicture cpu(world, view, settings);
        render_gpu(frame);
        const std::vector<float>&a = gpu_film[Aov::geometric_normal].value,
              &b = cpu.film[Aov::geometric_normal].value;
        EXPECT_EQ(test::count_different(a, b, 1e-4f), 0u);
        hits += std::size_t(std::count(item.begin(), item.end(), 0u));
    }
    EXPECT_GT(hits, 1000u);
}

} // namespace
} // namespace firsthit
