// engines.h - chooses the engine that makes a frame.
#pragma once

#include "base/process_owned.h"
#include "cpu/frame.h"
#include "frame/frame_context.h"

#include <firsthit/render.h>

#include <string>

namespace firsthit {

class OpenGlEngines;

/// The engines of one renderer. The OpenGL engines are made when they are first needed, and deleted
/// if they fail.
class Engines {
  public:
    Engines();
    ~Engines();

    /// Renders the frame with the engine that the settings name. `settings` and the frame's view
    /// must have passed check_settings.h.
    /// throws  DeviceError, Cancelled: see Renderer::render
    void render(const FrameContext& frame, const Settings& settings, Stats& stats);

    /// The engine of the last frame.
    const EngineInfo& info() const { return info_; }

  private:
    /// The OpenGL engines; makes them if there are none.
    OpenGlEngines& opengl();
    bool has_hardware();
    void render_by(Engine engine, const FrameContext& frame, Stats& stats);

    FrameMemory memory_;
    Settings settings_; // of the frame, with `automatic` resolved; a member to keep its memory
    ProcessOwned<OpenGlEngines> opengl_;
    EngineInfo info_;
    std::string refusal_; // why Engine::automatic does not use OpenGL; found out once
};

} // namespace firsthit
