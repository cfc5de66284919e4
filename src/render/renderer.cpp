// renderer.cpp - the public renderer: poses, checks, and hands the frame to the engine.
#include "base/instruction_set.h"
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "render/check_settings.h"
#include "scene/pose.h"

#include <firsthit/error.h>
#include <firsthit/render.h>

#include <new>

namespace firsthit {

struct Renderer::Impl {
    explicit Impl(int threads) : tasks(threads) { select_instruction_set(); }

    void frame(const World& world, const View& view, const Settings& settings, Film& film)
    {
        check(settings);
        const View filled = checked(view);
        stats.vertices = world.position.size();
        stats.triangles = world.scene->triangle_count();
        try {
            render_frame(world, filled, settings, memory, tasks, film, stats);
        } catch (const std::bad_alloc&) {
            throw Error("not enough memory for a picture of this size");
        }
    }

    Tasks tasks;
    World posed;
    FrameMemory memory;
    Stats stats;
};

Renderer::Renderer(int threads) : impl_(std::make_unique<Impl>(threads)) {}
Renderer::~Renderer() = default;

void Renderer::render(
    const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film)
{
    Stopwatch total, watch;
    impl_->stats = {};
    pose(scene, time_s, impl_->posed, impl_->tasks);
    impl_->stats.pose_ms = watch.lap_ms();
    impl_->frame(impl_->posed, view, settings, film);
    impl_->stats.total_ms = total.lap_ms();
}

void Renderer::render(const World& world, const View& view, const Settings& settings, Film& film)
{
    Stopwatch total;
    impl_->stats = {};
    impl_->frame(world, view, settings, film);
    impl_->stats.total_ms = total.lap_ms();
}

const Stats& Renderer::stats() const
{
    return impl_->stats;
}

int Renderer::threads() const
{
    return impl_->tasks.threads();
}

} // namespace firsthit
