// gpu_frame_test.cpp - the gpu engine's pictures are the cpu engine's, given the same items and maps.
#include "gl/gpu_pictures.h"

#include "lights.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace firsthit {
namespace {

/// FIRSTHIT_KEEP_PICTURES=folder keeps pictures to look at.
void keep(const Film& film, const std::string& name)
{
    if (const char* folder = std::getenv("FIRSTHIT_KEEP_PICTURES"))
        write_color(film, std::string(folder) + "/" + name + ".png");
}

class GpuFrame : public test::OnContext {
  protected:
    /// A built-in scene from the front.
    void load(const std::string& name, double time_s = 0, int size = 256)
    {
        scene = load_scene(name);
        pose_at(time_s);
        view.width = view.height = size;
    }
    void pose_at(double time_s)
    {
        pose(scene, time_s, world);
        view.camera = scene.camera ? world.camera : framing_camera(world);
    }

    /// Of the items and maps of the cpu engine's.
    void render_both(const std::string& name)
    {
        const test::CpuPicture cpu(world, view, settings);
        gl::GpuFrame frame(*context);
        test::GivenItems items;
        items.item = cpu.film.item;
        Stats stats;
        settings.multisample = Multisample::exact;
        const ShadowMaps* maps = settings.shadows == Shadows::map ? &cpu.memory.lit.maps : nullptr;
        frame.render(world, checked(view), settings, items, tasks, gpu_film, stats, maps);
        cpu_film = cpu.film;
        keep(cpu_film, name + "_cpu");
        keep(gpu_film, name + "_gpu");
    }

    Tasks tasks{2};
    Scene scene;
    World world;
    View view;
    Settings settings;
    Film cpu_film, gpu_film;
};

TEST_F(GpuFrame, ShadesATorusAsTheCpuDoes)
{
    load("builtin:torus");
    settings.shadows = Shadows::none;
    render_both("torus");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 60);
}

TEST_F(GpuFrame, ShadesRobotsWithShadowsAsTheCpuDoes)
{
    load("builtin:robots", 1.5);
    settings.shadows = Shadows::map;
    render_both("robots");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 60);
}

} // namespace
} // namespace firsthit
