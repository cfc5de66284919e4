// renderer.cpp - the public renderer: poses, checks, and hands the frame to the engine.
#include "base/instruction_set.h"
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "render/check_settings.h"
#include "render/engines.h"
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
        stats.vertices = world.position.size();
        stats.triangles = world.scene->triangle_count();
        try {
            FrameProgress progress(control);
            progress.check();
            engines.render({world, filled, tasks, film, &progress}, settings, stats);
            progress.finish();
        } catch (const std::bad_alloc&) {
            throw Error("not enough memory for a picture of this size");
        }
    }

    Tasks tasks;
    World posed;
    Engines engines;
    Stats stats;
    double pose_ms = 0; // since the last frame
};

Renderer::Renderer(int threads) : impl_(std::make_unique<Impl>(threads)) {}
Renderer::~Renderer() = default;

void Renderer::render(
    const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film)
{
    // The world is looked at during the call only.
    pose(borrow(scene), time_s, impl_->posed);
    render(impl_->posed, view, settings, film);
}

void Renderer::pose(std::shared_ptr<const Scene> scene, double time_s, World& world)
{
    Stopwatch watch;
    firsthit::pose(std::move(scene), time_s, world, impl_->tasks);
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
