// gpu_bench.cpp - the gpu engine stage by stage, in one pass and in several: medians of frames.
//
//     gpu_bench [scene...]     1024 x 1024, moving; FIRSTHIT_GPU_FRAMES frames each (9)
//
// The setup stage poses and uploads, raster draws the items, resolve is what several passes do
// before shading, shadow bounds the hits and draws maps, shade has the colours. A software driver
// works when it is waited for, which each stage does; with hardware only the total counts.
#include "gl/items/drawn_items.h"
#include "gl/gpu_frame.h"
#include "render/check_settings.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace firsthit;

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

struct Way {
    const char* name;
    Shadows shadows;
    GpuPasses passes;
};

void measure(
    gl::GpuFrame& frame, gl::DrawnItems& items, const std::string& name, const Way& way, int frames)
{
    const Scene scene = load_scene(name);
    World world;
    View view;
    Settings settings;
    settings.shadows = way.shadows;
    settings.opengl.passes = way.passes;
    Tasks tasks(0);
    Film film;
    std::vector<double> setup, raster, resolve, shadow, shade, total;
    std::uint64_t maps = 0;
    for (int k = -2; k < frames; ++k) {
        pose(borrow(scene), 0.04 * (k + 2), world);
        if (k == -2) view.camera = world.camera;
        Stats stats;
        Stopwatch watch;
        const View filled = checked(view);
        frame.render({world, filled, tasks, film}, settings, {items}, stats);
        if (k < 0) continue; // shaders are compiled, memory grows
        total.push_back(watch.lap_ms());
        setup.push_back(stats.setup_ms);
        raster.push_back(stats.raster_ms);
        resolve.push_back(stats.resolve_ms);
        shadow.push_back(stats.shadow_ms);
        shade.push_back(stats.shade_ms);
        maps += stats.map_updates;
    }
    std::puts(fmt::format("{:16} {:18} {:7.1f} {:7.1f} {:7.1f} {:7.1f} {:7.1f} {:7.1f} {:6.1f}",
        name, way.name, median(setup), median(raster), median(resolve), median(shadow),
        median(shade), median(total), double(maps) / frames)
                  .c_str());
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty()) names = {"builtin:torus", "builtin:robots"};
    const char* count = std::getenv("FIRSTHIT_GPU_FRAMES");
    const int frames = std::max(1, count ? std::atoi(count) : 9);
    try {
        gl::Context context;
        const gl::Current current(context);
        std::puts(gl::driver_name().c_str());
        std::puts(fmt::format("{:16} {:18} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6}", "scene", "",
            "setup", "raster", "resolve", "shadow", "shade", "total", "maps")
                      .c_str());
        gl::GpuFrame frame(context);
        gl::DrawnItems items(context);
        for (const std::string& name : names)
            for (const Way& way : {Way{"single", Shadows::none, GpuPasses::single},
                     Way{"multi", Shadows::none, GpuPasses::multi},
                     Way{"single, shadows", Shadows::map, GpuPasses::single},
                     Way{"multi, shadows", Shadows::map, GpuPasses::multi}})
                measure(frame, items, name, way, frames);
    } catch (const Error& error) {
        std::fprintf(stderr, "gpu_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
