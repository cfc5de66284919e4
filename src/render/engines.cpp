// engines.cpp - chooses the engine that makes a frame.
#include "render/engines.h"

#ifdef FIRSTHIT_GL
#include "render/opengl_engines.h"
#endif

#include "exact/cutouts.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit {

#ifndef FIRSTHIT_GL
class OpenGlEngines {};
#endif

Engines::Engines() = default;
Engines::~Engines() = default;

OpenGlEngines& Engines::opengl()
{
#ifdef FIRSTHIT_GL
    if (!opengl_) opengl_ = make_process_owned<OpenGlEngines>();
    if (!opengl_.get_deleter().is_home()) gl::refuse_after_fork();
    return *opengl_;
#else
    throw DeviceError("this build has no OpenGL (FIRSTHIT_BUILD_GL=OFF)");
#endif
}

/// Whether OpenGL runs on hardware. If not, sets refusal_.
bool Engines::has_hardware()
{
    if (!refusal_.empty()) return false;
    try {
#ifdef FIRSTHIT_GL
        if (opengl().is_hardware()) return true;
        refusal_ = fmt::format("OpenGL runs on no hardware here: {}", opengl().device());
#else
        opengl();
#endif
    } catch (const DeviceError& error) {
        refusal_ = error.what();
    }
    opengl_.reset(); // it will not be used
    return false;
}

void Engines::render_by(Engine engine, const FrameContext& frame, Stats& stats)
{
    info_.engine = engine;
    info_.device.clear();
    settings_.engine = engine;
    if (settings_.shadows == Shadows::automatic)
        settings_.shadows = engine == Engine::cpu ? Shadows::exact : Shadows::map;
    if (engine == Engine::cpu) {
        render_frame(frame, settings_, memory_, stats);
        return;
    }
    if (frame.view.camera.orthographic_height)
        throw ArgumentError("orthographic cameras are rendered by the cpu engine alone");
    try {
        OpenGlEngines& engines = opengl();
#ifdef FIRSTHIT_GL
        info_.device = engines.device();
        if (engine == Engine::gpu)
            engines.render_gpu(frame, settings_, stats);
        else
            engines.render_hybrid(frame, settings_, memory_, stats);
#else
        (void)engines;
#endif
    } catch (const ArgumentError&) {
        throw; // nothing was drawn yet
    } catch (const Cancelled&) {
        throw; // between two stages, so the engine can still be used
    } catch (...) {
        opengl_.reset(); // a lost context, or no memory: the next frame makes new engines
        throw;
    }
}

void Engines::render(const FrameContext& frame, const Settings& settings, Stats& stats)
{
    settings_ = settings;
    info_.reason.clear();
    if (settings.engine != Engine::automatic) {
        render_by(settings.engine, frame, stats);
        return;
    }
    if (frame.view.camera.orthographic_height) {
        info_.reason = "orthographic cameras are drawn by the cpu engine";
    } else if (settings.shadows == Shadows::exact) {
        info_.reason = "exact shadows are made by the cpu engine";
    } else if (has_cutouts(*frame.world.scene) || has_blended_triangles(*frame.world.scene)) {
        info_.reason = "surfaces with an alpha mode are drawn by the cpu engine";
    } else if (has_hardware()) {
        const Stats before = stats;
        try {
            info_.reason = "OpenGL runs on hardware here";
            render_by(Engine::gpu, frame, stats);
            return;
        } catch (const DeviceError& error) {
            refusal_ = error.what();
            stats = before;
            settings_ = settings;
            info_.reason = refusal_;
        }
    } else {
        info_.reason = refusal_;
    }
    render_by(Engine::cpu, frame, stats);
}

} // namespace firsthit
