// render.h - makes pictures of scenes.
#pragma once

#include <firsthit/film.h>
#include <firsthit/frame_control.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>
#include <firsthit/view.h>

#include <memory>
#include <string>

namespace firsthit {

/// The engine that made a frame.
struct EngineInfo {
    Engine engine = Engine::cpu; // the engine, never automatic
    std::string device;          // OpenGL's renderer and version; empty if OpenGL was not used
    std::string reason;          // for Engine::automatic: why this engine was chosen; else empty
};

/// Renders frames, and keeps memory and threads from frame to frame. Not thread-safe: one frame at
/// a time, but different threads may take turns. The OpenGL engines have their own context. It is
/// current on the caller's thread only during render(), which restores the caller's context
/// afterwards.
///
/// limits  after fork(), a child process must make its own renderer and use the cpu engine, because
///         the threads of OpenGL drivers exist only in the parent
///         the OpenGL engines compute rigid parts from the scene and World::node_matrix, and take
///         other parts from World::position: they ignore positions of rigid parts that were changed
///         after pose()
class Renderer {
  public:
    /// threads  number of threads; 0: one for each core
    explicit Renderer(int threads = 0);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Poses the scene at a time in seconds and makes the picture. The film's memory is reused if
    /// the same film is passed again. The scene is used only during the call.
    /// throws  ArgumentError: a size, region, number of samples, camera, sky or shadow setting out
    ///         of range; Aov::lit for a world without lights or with more than kMaxLitLights; a
    ///         previous frame of another scene; interleaving with an environment as background
    ///         SceneError: an invalid light, and as firsthit::pose
    ///         DeviceError: an OpenGL engine is not available or fails: no OpenGL 4.5, not enough
    ///         memory, a lost context. The next frame makes a new context. Engine::automatic uses
    ///         the cpu engine instead
    ///         Error: not enough memory for the picture
    void render(
        const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film);

    /// Poses the scene on the renderer's threads, for render() with a world, so that a caller can
    /// read or change the world first, for example its camera. The time that this takes is part of
    /// the next frame's statistics. The world shares ownership of the scene.
    /// throws  as firsthit::pose
    void pose(std::shared_ptr<const Scene> scene, double time_s, World& world);

    /// The same of a chosen clip and camera.
    void pose(std::shared_ptr<const Scene> scene, const PoseSettings& settings, World& world);

    /// Makes the picture of a world that is posed already; says how far it is, and gives it up when
    /// it is asked to.
    /// throws  as the first render
    ///         Cancelled: a stop was requested before the frame was done. The film then has the
    ///         frame's size and planes, with parts of the new picture, or it is as before where
    ///         nothing had begun; the statistics are of what was done. The next frame is as if this
    ///         one had never been asked for
    void render(const World& world, const View& view, const Settings& settings, Film& film,
        const FrameControl& control = {});

    /// Statistics of the last frame.
    const Stats& stats() const;

    /// The engine of the last frame.
    const EngineInfo& engine() const;

    /// The number of threads, including the caller's.
    int threads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The instruction set that the kernels use on this machine: "AVX3", "AVX2", "SSE4" or "SCALAR".
/// The environment variable FIRSTHIT_ISA can choose a lower one.
/// throws  ArgumentError: FIRSTHIT_ISA names an instruction set that is not available
std::string instruction_set();

/// The version of the library, such as "0.1.0".
std::string version();

} // namespace firsthit
