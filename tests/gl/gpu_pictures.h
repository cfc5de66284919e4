// gpu_pictures.h - pictures of the gpu engine and of the cpu engine, and how much they differ.
#pragma once

#include "cpu/frame.h"
#include "gl/items/given_items.h"
#include "gl/gl_context.h"
#include "gl/gpu_frame.h"
#include "render/check_settings.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace firsthit::test {

/// The cpu engine's picture, with its items and shadow maps.
struct CpuPicture {
    FrameMemory memory;
    Film film;
    Stats stats;

    CpuPicture(const World& world, const View& view, const Settings& settings)
    {
        Tasks tasks(2);
        const View filled = checked(view);
        render_frame({world, filled, tasks, film}, settings, memory, stats);
    }
};

/// The pencil of a picture that is `samples` times as large: it has the same rays.
inline std::vector<std::uint32_t> cpu_items(const World& world, View view, int samples = 1)
{
    for (int* size : {&view.width, &view.height, &view.region.x, &view.region.y, &view.region.width,
             &view.region.height})
        *size *= samples;
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    settings.shadows = Shadows::none;
    return CpuPicture(world, view, settings).film.item;
}

/// 10 log10(1 / mean square difference) of values in [0, 1]; greater values are clamped.
inline double psnr(const std::vector<float>& a, const std::vector<float>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        const double d = double(std::clamp(a[k], 0.0f, 1.0f)) - std::clamp(b[k], 0.0f, 1.0f);
        sum += d * d;
    }
    return sum > 0 ? 10 * std::log10(double(a.size()) / sum)
                   : std::numeric_limits<double>::infinity();
}

/// The number of values that differ by more than `tolerance`.
inline std::size_t count_different(
    const std::vector<float>& a, const std::vector<float>& b, float tolerance)
{
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        count += !(a[k] == b[k] || std::abs(a[k] - b[k]) <= tolerance);
    return count;
}

/// Writes the pictures to the folder in FIRSTHIT_KEEP_PICTURES, if that is set.
inline void keep(const Film& film, const std::string& name)
{
    if (film.color.empty()) return;
    if (const char* folder = std::getenv("FIRSTHIT_KEEP_PICTURES"))
        write_color(film, std::string(folder) + "/" + name + ".png");
}

class OnGpu : public OnContext {
  protected:
    /// Loads a built-in scene, seen from the front.
    void load(const std::string& name, double time_s = 0, int size = 256)
    {
        scene = load_scene(name);
        pose_at(time_s);
        view.width = view.height = size;
    }
    void pose_at(double time_s)
    {
        pose(borrow(scene), time_s, world);
        view.camera = world.camera;
    }

    /// Renders with the cpu engine's items. maps: see gl::GpuSources.
    void render_gpu(gl::GpuFrame& frame, const ShadowMaps* maps = nullptr)
    {
        item = cpu_items(world, view, settings.samples);
        std::vector<std::uint32_t> changed = item;
        if (change_items) change_items(changed);
        gl::GivenItems items;
        items.set(changed);
        stats = {};
        render_gpu(frame, gpu_film, {items, maps});
    }

    /// Renders with the given items and maps.
    void render_gpu(gl::GpuFrame& frame, Film& film, const gl::GpuSources& sources)
    {
        const View filled = checked(view);
        frame.render({world, filled, tasks, film}, settings, sources, stats);
    }

    /// Renders with the cpu engine's items and maps.
    void render_both(const std::string& name)
    {
        const CpuPicture cpu(world, view, settings);
        cpu_film = cpu.film;
        gl::GpuFrame frame(*context);
        render_gpu(frame, settings.shadows == Shadows::map ? &cpu.memory.lit.maps : nullptr);
        keep(cpu_film, name + "_cpu");
        keep(gpu_film, name + "_gpu");
    }

    Tasks tasks{2};
    Scene scene;
    World world;
    View view;
    Settings settings = exact_settings();
    std::vector<std::uint32_t> item; // of the last picture
    Stats stats;
    Film cpu_film, gpu_film;
    std::function<void(std::vector<std::uint32_t>&)> change_items;

  private:
    /// Settings for exact items, which need no repair.
    static Settings exact_settings()
    {
        Settings exact;
        exact.multisample = Multisample::exact;
        return exact;
    }
};

} // namespace firsthit::test
