// renderer.cpp - the public renderer: poses the scene, checks arguments, and calls the engine.
#include "base/instruction_set.h"
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "render/camera_planes.h"
#include "render/check_settings.h"
#include "render/coverage.h"
#include "render/engines.h"
#include "render/id_planes.h"
#include "render/surface_planes.h"
#include "scene/model/check_light.h"
#include "scene/animate/pose.h"
#include "scene/model/borrow.h"

#include <firsthit/error.h>
#include <firsthit/render.h>

#include <new>
#include <utility>

namespace firsthit {

struct Renderer::Impl {
    explicit Impl(int threads) : tasks(threads) { select_instruction_set(); }

    void frame(const World& world, const View& view, const Settings& settings, Film& film,
        const FrameControl& control)
    {
        if (!world.scene) throw ArgumentError("the world has no scene: pose it first");
        check(settings, world.lights.size());
        check_lights(world);
        const View filled = checked(view);
        check_previous(world, filled, settings.previous);
        check_background(*world.scene, settings);
        stats.vertices = world.position.size();
        stats.triangles = world.scene->triangle_count();
        try {
            FrameProgress progress(control);
            progress.check();
            id_planes.without(settings, own);
            surface_planes.without(own);
            camera_planes.without(own);
            film.alpha.value.clear();
            engines.render({world, filled, tasks, film, &progress}, own, stats);
            if (settings.alpha && film.alpha.empty())
                coverage.fill({world, filled, tasks, film, &progress}, own);
            camera_planes.fill(filled, tasks, film);
            surface_planes.fill(world, filled, settings, tasks, film);
            id_planes.fill(*world.scene, tasks, film);
            progress.finish();
        } catch (const std::bad_alloc&) {
            throw Error("not enough memory for a picture of this size");
        }
    }

    Tasks tasks;
    World posed;
    Engines engines;
    IdPlanes id_planes;
    SurfacePlanes surface_planes;
    CameraPlanes camera_planes;
    Coverage coverage;
    Settings own; // what the engines are asked for: their memory is reused
    Stats stats;
    double pose_ms = 0; // since the last frame
};

Renderer::Renderer(int threads) : impl_(std::make_unique<Impl>(threads)) {}
Renderer::~Renderer() = default;

void Renderer::render(
    const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film)
{
    // The world is used only during the call, so it need not own the scene.
    pose(borrow(scene), time_s, impl_->posed);
    render(impl_->posed, view, settings, film);
}

void Renderer::pose(std::shared_ptr<const Scene> scene, double time_s, World& world)
{
    pose(std::move(scene), PoseSettings{.time_s = time_s}, world);
}

void Renderer::pose(std::shared_ptr<const Scene> scene, const PoseSettings& settings, World& world)
{
    Stopwatch watch;
    firsthit::pose(std::move(scene), settings, world, impl_->tasks);
    impl_->pose_ms += watch.lap_ms();
}

void Renderer::render(const World& world, const View& view, const Settings& settings, Film& film,
    const FrameControl& control)
{
    Stopwatch watch;
    impl_->stats = {};
    impl_->stats.pose_ms = std::exchange(impl_->pose_ms, 0);
    impl_->frame(world, view, settings, film, control);
    impl_->stats.total_ms = impl_->stats.pose_ms + watch.lap_ms();
}

const Stats& Renderer::stats() const
{
    return impl_->stats;
}

const EngineInfo& Renderer::engine() const
{
    return impl_->engines.info();
}

int Renderer::threads() const
{
    return impl_->tasks.threads();
}

} // namespace firsthit
