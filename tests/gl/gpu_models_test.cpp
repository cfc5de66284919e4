// gpu_models_test.cpp - the gpu engine shades every model as the cpu engine does.
#include "gl/gpu_pictures.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <variant>

namespace firsthit {
namespace {

class GpuModels : public test::OnGpu {
  protected:
    /// Every `every`-th material shows its diffuse colour unlit.
    void make_unlit(std::size_t every)
    {
        for (std::size_t m = 0; m < scene.materials.size(); m += every) {
            const Phong phong = std::get<Phong>(scene.materials[m].model);
            scene.materials[m].model = Unlit{.color = phong.diffuse, .texture = phong.texture};
        }
    }
};

TEST_F(GpuModels, SceneOfSeveralIsThatOfTheCpuEngine)
{
    if (!context) return;
    load("builtin:robots", 2.5);
    make_unlit(3);
    settings.shadows = Shadows::map;
    render_both("models");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90);
}

TEST_F(GpuModels, UnlitPictureIsItsAlbedo)
{
    if (!context) return;
    load("builtin:robots", 2.5);
    make_unlit(1);
    scene.background = {};
    settings.shadows = Shadows::map;
    settings.aovs = {Aov::albedo, Aov::lit};
    render_both("unlit");
    EXPECT_EQ(cpu_film.color.value, cpu_film[Aov::albedo].value);
    EXPECT_EQ(gpu_film.color.value, gpu_film[Aov::albedo].value);
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90);
    // Shadows are found all the same.
    const auto shadowed = [](const Film& film) {
        const std::vector<float>& lit = film[Aov::lit].value;
        return std::count(lit.begin(), lit.end(), 0.0f) != std::ptrdiff_t(lit.size()) &&
               std::count(lit.begin(), lit.end(), 1.0f) != std::ptrdiff_t(lit.size());
    };
    EXPECT_TRUE(shadowed(cpu_film));
    EXPECT_TRUE(shadowed(gpu_film));
}

} // namespace
} // namespace firsthit
