// engines.h - which engine makes a frame.
#pragma once

#include "base/process_owned.h"
#include "base/tasks.h"
#include "cpu/frame.h"

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

    /// Renders the frame by the engine that the settings ask for. `settings` and `view` are checked;
    /// view.region is filled in.
    /// throws  DeviceError: see Renderer::render
    void render(const World& world, const View& view, const Settings& settings, Tasks& tasks,
        Film& film, Stats& stats);

    /// Of the last frame.
    const EngineInfo& info() const { return info_; }

  private:
    /// The OpenGL engines; made now where there are none.
    OpenGlEngines& opengl();
    bool has_hardware();
    void render_by(Engine engine, const World& world, const View& view, Tasks& tasks, Film& film,
        Stats& stats);

    FrameMemory memory_;
    Settings settings_; // of the frame, nothing automatic; its memory is kept
    ProcessOwned<OpenGlEngines> opengl_;
    EngineInfo info_;
    std::string refusal_; // why there is no OpenGL for Engine::automatic; it is asked once
};

} // namespace firsthit
