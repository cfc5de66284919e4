// renderer.h - renderers as Python uses them: without the interpreter's lock, stopped by Ctrl-C.
#pragma once

#include "camera.h"
#include "numbers.h"
#include "posed.h"

#include <firsthit/render.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::python {

/// A film and how it was made.
struct Frame {
    Film film;
    Stats stats;
    std::string engine;
};

/// What is rendered of a world.
struct Shot {
    SizedCamera camera;
    std::optional<std::array<int, 4>> region; // x, y, width, height
    std::optional<std::vector<Light>> lights; // in the place of the world's
    PosedWorld* previous = nullptr;           // for planes of motion
    std::optional<SizedCamera> previous_camera;
};

/// A renderer for one thread at a time: a second one waits.
class PythonRenderer {
  public:
    explicit PythonRenderer(const pybind11::object& threads) : renderer_(thread_count(threads)) {}

    int threads() const { return renderer_.threads(); }

    /// Renders into `frame`, whose memory is used again.
    /// progress  None, or a function of the share that is done, which may raise
    void render(PosedWorld& world, const SizedCamera& camera, const Settings& settings,
        const pybind11::object& extras, Frame& frame);

  private:
    Renderer renderer_;
    std::mutex turn_;
};

/// A frame for each camera, on several threads, each with a renderer of one thread of its own.
/// threads  0: one for each core
std::vector<std::unique_ptr<Frame>> render_batch(PosedWorld& world,
    const std::vector<SizedCamera>& cameras, const Settings& settings,
    const std::optional<std::vector<Light>>& lights, const pybind11::object& threads);

} // namespace firsthit::python
