// opengl_engines.cpp - the engines that run on OpenGL, and what they keep from frame to frame.
#include "render/opengl_engines.h"

#include <fmt/format.h>

namespace firsthit {

OpenGlEngines::~OpenGlEngines()
{
    hybrid_.reset();
    const gl::Current current(context_);
    certified_items_.reset();
    drawn_items_.reset();
    gpu_.reset();
    scene_.reset();
}

std::string OpenGlEngines::device() const
{
    return fmt::format("{}, OpenGL {}", context_.info().renderer, context_.info().version);
}

void OpenGlEngines::render_hybrid(const World& world, const View& view, const Settings& settings,
    FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    if (!scene_) {
        const gl::Current current(context_);
        scene_.emplace(context_, gl::Detail::surfaces);
    }
    if (!hybrid_) hybrid_.emplace(context_, *scene_);
    hybrid_->items.set(settings);
    const std::uint64_t uploaded = scene_->uploaded_bytes();
    render_frame(world, view, settings, memory, tasks, film, stats,
        {.items = &hybrid_->items, .maps = &hybrid_->maps});
    const gl::HybridTimes times = hybrid_->items.take_times();
    stats.draw_ms += times.draw_ms;
    stats.transfer_ms += times.transfer_ms;
    stats.wait_ms += times.waiting_ms;
    stats.uncertain_samples += times.uncertain;
    stats.uploaded_bytes += scene_->uploaded_bytes() - uploaded;
}

void OpenGlEngines::render_gpu(const World& world, const View& view, const Settings& settings,
    Tasks& tasks, Film& film, Stats& stats, gl::GpuItems* items, const ShadowMaps* maps)
{
    const gl::Current current(context_);
    if (!gpu_) gpu_.emplace(context_);
    if (!items && settings.multisample == Multisample::exact) {
        if (!certified_items_) certified_items_.emplace(context_);
        items = &*certified_items_;
    } else if (!items) {
        if (!drawn_items_) drawn_items_.emplace(context_);
        items = &*drawn_items_;
    }
    gpu_->render(world, view, settings, *items, tasks, film, stats, maps);
    if (certified_items_) stats.uncertain_samples += certified_items_->take_uncertain();
}

} // namespace firsthit
