// engines.h - which engine makes a frame.
#pragma once

#include "base/process_owned.h"
#include "cpu/frame.h"
#include "frame/frame_context.h"

#include <firsthit/render.h>

#include <string>

namespace firsthit {

class OpenGlEngines;

/// The engines of one renderer. Those on OpenGL are made when first asked for, and given up when
/// they fail.
class Engines {
  public:
    Engines();
    ~Engines();

    /// Renders the frame by the engine that the settings ask for. `settings` and the frame's view are
    /// checked.
    /// throws  DeviceError, Cancelled: see Renderer::render
    void render(const FrameContext& frame, const Settings& settings, Stats& stats);

    /// Of the last frame.
    const EngineInfo& info() const { return info_; }

  private:
    /// The OpenGL engines; made now where there are none.
    OpenGlEngines& opengl();
    bool has_hardware();
    void render_by(Engine engine, const FrameContext& frame, Stats& stats);

    FrameMemory memory_;
    Settings settings_; // of the frame, nothing automatic; its memory is kept
    ProcessOwned<OpenGlEngines> opengl_;
    EngineInfo info_;
    std::string refusal_; // why there is no OpenGL for Engine::automatic; it is asked once
};

} // namespace firsthit
