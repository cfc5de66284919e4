// opengl_engines.cpp - the hybrid and the gpu engine, and their OpenGL context.
#include "render/opengl_engines.h"

#include "exact/cutouts.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit {

OpenGlEngines::~OpenGlEngines()
{
    hybrid_.reset();
    const gl::Current current(context_);
    given_items_.reset();
    certified_items_.reset();
    drawn_items_.reset();
    gpu_.reset();
    scene_.reset();
}

std::string OpenGlEngines::device() const
{
    return fmt::format("{}, OpenGL {}", context_.info().renderer, context_.info().version);
}

void OpenGlEngines::render_hybrid(
    const FrameContext& frame, const Settings& settings, FrameMemory& memory, Stats& stats)
{
    if (!scene_) {
        const gl::Current current(context_);
        scene_.emplace(context_, gl::Detail::surfaces);
    }
    if (!hybrid_) hybrid_.emplace(context_, *scene_);
    hybrid_->items.set(settings);
    hybrid_->items.take_times(); // discards those of a cancelled frame
    const std::uint64_t uploaded = scene_->uploaded_bytes();
    // OpenGL's maps know no cut-outs: then the rasteriser makes the maps.
    gl::HybridMaps* const maps = has_cutouts(*frame.world.scene) ? nullptr : &hybrid_->maps;
    render_frame(frame, settings, memory, stats, {.items = &hybrid_->items, .maps = maps});
    const gl::HybridTimes times = hybrid_->items.take_times();
    stats.draw_ms += times.draw_ms;
    stats.transfer_ms += times.transfer_ms;
    stats.wait_ms += times.waiting_ms;
    stats.uncertain_samples += times.uncertain;
    stats.uploaded_bytes += scene_->uploaded_bytes() - uploaded;
}

void OpenGlEngines::render_gpu(const FrameContext& frame, const Settings& settings, Stats& stats)
{
    if (has_blended_triangles(*frame.world.scene))
        throw ArgumentError(
            "the gpu engine draws no blended surfaces, which materials of the scene ask "
            "for (alpha blend): another engine does");
    const bool cutouts = has_cutouts(*frame.world.scene);
    if (cutouts && settings.shadows != Shadows::none && !frame.world.lights.empty())
        throw ArgumentError("the gpu engine's shadow maps know no cut-outs, which materials of the "
                            "scene ask for (alpha mask): accepted are no shadows, or "
                            "another engine");
    if (hybrid_) hybrid_->items.let_go();
    const gl::Current current(context_);
    if (!gpu_) gpu_.emplace(context_);
    if (cutouts || settings.multisample == Multisample::exact) {
        if (!certified_items_) certified_items_.emplace(context_);
        certified_items_->take_uncertain(); // discards those of a cancelled frame
        Settings exact = settings;
        exact.multisample = Multisample::exact;
        gpu_->render(frame, exact, {*certified_items_}, stats);
        stats.uncertain_samples += certified_items_->take_uncertain();
    } else {
        if (!drawn_items_) drawn_items_.emplace(context_);
        gpu_->render(frame, settings, {*drawn_items_}, stats);
    }
}

void OpenGlEngines::render_gpu_with(std::span<const std::uint32_t> items, const ShadowMaps* maps,
    const FrameContext& frame, const Settings& settings, Stats& stats)
{
    if (hybrid_) hybrid_->items.let_go();
    const gl::Current current(context_);
    if (!gpu_) gpu_.emplace(context_);
    if (!given_items_) given_items_.emplace();
    given_items_->set(items);
    gpu_->render(frame, settings, {*given_items_, maps}, stats);
}

} // namespace firsthit
