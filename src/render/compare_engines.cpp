// compare_engines.cpp - compares the OpenGL engines with the cpu engine.
#include "base/instruction_set.h"
#include "base/process_owned.h"
#include "base/srgb.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "rays/brute.h"
#include "render/check_settings.h"
#ifdef FIRSTHIT_GL
#include "render/opengl_engines.h"
#endif
#include "scene/model/check_light.h"
#include "visibility/bin/project.h"

#include <firsthit/compare.h>
#include <firsthit/error.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace firsthit {
namespace {

/// Values that are compared by one call. The sums of these ranges are added in order, so that the
/// result does not depend on the number of threads.
constexpr std::size_t kRange = 4096;

struct Difference {
    double square_sum = 0;
    double largest = 0;
};

Difference difference(const std::vector<float>& a, const std::vector<float>& b, Tasks& tasks)
{
    std::vector<Difference> of_range((a.size() + kRange - 1) / kRange);
    tasks.for_ranges(a.size(), kRange, [&](std::size_t first, std::size_t last) {
        Difference& range = of_range[first / kRange];
        for (std::size_t k = first; k < last; ++k) {
            if (a[k] == b[k]) continue;
            const double d = std::abs(srgb_value(a[k]) - srgb_value(b[k]));
            range.square_sum += d * d;
            range.largest = std::max(range.largest, d);
        }
    });
    Difference sum;
    for (const Difference& range : of_range) {
        sum.square_sum += range.square_sum;
        sum.largest = std::max(sum.largest, range.largest);
    }
    return sum;
}

} // namespace

struct EngineComparer::Impl {
    explicit Impl(int threads) : tasks(threads) {}

    void render_engine(
        const World& world, const View& view, const Settings& settings, Stats& stats);
    void count_items(const World& world, const View& view, EngineComparison& result);
    std::optional<double> lend_items(
        const World& world, const View& view, const Settings& settings);

    Tasks tasks;
    FrameMemory cpu_memory, engine_memory;
    Film cpu_film, engine_film, lent_film;
    ViewMemory eye; // corners
    std::string device;
#ifdef FIRSTHIT_GL
    ProcessOwned<OpenGlEngines> opengl;
#endif
};

#ifdef FIRSTHIT_GL

void EngineComparer::Impl::render_engine(
    const World& world, const View& view, const Settings& settings, Stats& stats)
{
    if (!opengl) opengl = make_process_owned<OpenGlEngines>();
    if (!opengl.get_deleter().is_home()) gl::refuse_after_fork();
    device = opengl->device();
    if (settings.engine == Engine::gpu)
        opengl->render_gpu({world, view, tasks, engine_film}, settings, stats);
    else
        opengl->render_hybrid({world, view, tasks, engine_film}, settings, engine_memory, stats);
}

/// Renders the frame with the gpu engine from the items and maps of the cpu engine's frame, which
/// must have been rendered before.
/// returns  the sum of squared differences; nothing if the gpu engine cannot use the items
std::optional<double> EngineComparer::Impl::lend_items(
    const World& world, const View& view, const Settings& settings)
{
    const Region& region = view.region;
    const Pencil& last_section = cpu_memory.view.pencil;
    const bool at_once = last_section.width == region.width &&
                         last_section.height == region.height &&
                         std::max(region.width, region.height) <= gl::GpuOptions().section_side;
    if (settings.engine != Engine::gpu || settings.samples > 1 || !at_once) return std::nullopt;
    Settings lent = settings;
    lent.aovs.clear();
    lent.multisample = Multisample::exact; // the items need no repair
    const bool maps = settings.shadows == Shadows::map && !world.lights.empty();
    Stats stats;
    opengl->render_gpu_with(cpu_film.item, maps ? &cpu_memory.lit.maps : nullptr,
        {world, view, tasks, lent_film}, lent, stats);
    return difference(lent_film.color.value, cpu_film.color.value, tasks).square_sum;
}

#else

void EngineComparer::Impl::render_engine(const World&, const View&, const Settings&, Stats&)
{
    throw DeviceError("this build has no OpenGL (FIRSTHIT_BUILD_GL=OFF)");
}

std::optional<double> EngineComparer::Impl::lend_items(const World&, const View&, const Settings&)
{
    return std::nullopt;
}

#endif

/// Counts missed and wrong items and ties, relative to the cpu engine's items.
void EngineComparer::Impl::count_items(
    const World& world, const View& view, EngineComparison& result)
{
    Pencil pencil = pencil_of(view, view.region, 1);
    reach_all(world.position, pencil);
    eye.pencil = pencil;
    eye.pencil.width = eye.pencil.height = 1; // only corners are wanted, of any size of picture
    project_vertices(world.position, eye.pencil, eye, tasks);
    const EyeTriangles triangles{
        eye.corner.span().first(world.position.size()), world.scene->index};
    for (std::size_t k = 0; k < cpu_film.item.size(); ++k) {
        const std::uint32_t cpu = cpu_film.item[k], engine = engine_film.item[k];
        if (cpu == engine) continue;
        if (engine == kNoItem)
            ++result.missed;
        else
            ++(is_tie(triangles, cpu, engine, direction_of(pencil, k)) ? result.ties
                                                                       : result.wrong);
    }
}

EngineComparer::EngineComparer(int threads)
{
    select_instruction_set();
    impl_ = std::make_unique<Impl>(threads);
}
EngineComparer::~EngineComparer() = default;

EngineComparison EngineComparer::compare(
    const World& world, const View& view, const Settings& asked)
{
    if (asked.engine != Engine::hybrid && asked.engine != Engine::gpu)
        throw ArgumentError("only the hybrid and the gpu engine are compared with the cpu engine");
    Settings settings = asked;
    settings.color = true;
    settings.aovs = {Aov::item};
    if (settings.shadows == Shadows::automatic) settings.shadows = Shadows::map;
    check(settings, world.lights.size());
    check_lights(world);
    const View filled = checked(view);

    EngineComparison result;
    result.pixels = std::uint64_t(filled.region.width) * std::uint64_t(filled.region.height);
    Impl& impl = *impl_;
    Stats stats;
#ifdef FIRSTHIT_GL
    try {
#endif
        impl.render_engine(world, filled, settings, stats);
        result.interpolated = stats.interpolated;
        Settings cpu = settings;
        cpu.engine = Engine::cpu;
        impl.cpu_memory.lit.by_occluders = false; // the maps of all lights are needed
        render_frame({world, filled, impl.tasks, impl.cpu_film}, cpu, impl.cpu_memory, stats);
        result.square_sum_same_items = impl.lend_items(world, filled, settings);
#ifdef FIRSTHIT_GL
    } catch (const DeviceError&) {
        impl.opengl.reset(); // a lost context, or no memory
        throw;
    }
#endif
    impl.count_items(world, filled, result);
    const Difference seen =
        difference(impl.engine_film.color.value, impl.cpu_film.color.value, impl.tasks);
    result.square_sum = seen.square_sum;
    result.largest_difference = seen.largest;
    return result;
}

const Film& EngineComparer::engine_film() const
{
    return impl_->engine_film;
}

const Film& EngineComparer::cpu_film() const
{
    return impl_->cpu_film;
}

const std::string& EngineComparer::device() const
{
    return impl_->device;
}

EngineComparison compare_engines(
    const World& world, const View& view, const Settings& settings, int threads)
{
    return EngineComparer(threads).compare(world, view, settings);
}

} // namespace firsthit
