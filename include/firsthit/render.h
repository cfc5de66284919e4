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

/// What a frame was made on.
struct EngineInfo {
    Engine engine = Engine::cpu; // never automatic
    std::string device;          // OpenGL's renderer and version; empty: none was used
    std::string reason;          // of Engine::automatic: why it is this one; else empty
};

/// Renders frames; keeps the memory that they share. One frame at a time. The OpenGL engines have a
/// context of their own, which is current on the caller's thread only inside of render(), where it takes
/// the place of the caller's: so frames may come from different threads.
///
/// limits  after fork(), a child makes a renderer of its own and keeps to the cpu engine: drivers'
///         threads stay with the parent
///         the OpenGL engines take rigid parts from the scene and World::node_matrix, the others from
///         World::position: positions that the caller changed after pose() are not seen
class Renderer {
  public:
    /// threads  0: one for each core
    explicit Renderer(int threads = 0);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Poses the scene and makes the picture. A film's memory is reused by the next call that is
    /// given the same film. The scene is looked at during the call only.
    /// throws  ArgumentError: a size, region, sample count, camera or shadow setting out of range,
    ///         Aov::lit of a world without lights or with more than kMaxLitLights
    ///         SceneError: a light that contradicts itself
    ///         DeviceError: an OpenGL engine that is not there, or fails: no OpenGL 4.5, too little
    ///         memory, a lost context. The next frame starts anew. Engine::automatic takes the cpu
    ///         engine instead
    void render(
        const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film);

    /// Poses the scene on the renderer's threads, for render() with a world: who wants the camera
    /// of that time first. Counted in the next frame's statistics. The world shares the scene.
    /// throws  as firsthit::pose
    void pose(std::shared_ptr<const Scene> scene, double time_s, World& world);

    /// Makes the picture of a world that is posed already; says how far it is, and gives it up when
    /// it is asked to.
    /// throws  as the first render
    ///         Cancelled: a stop was requested before the frame was done. The film then has the
    ///         frame's size and planes, with parts of the new picture, or it is as before where
    ///         nothing had begun; the statistics are of what was done. The next frame is as if this
    ///         one had never been asked for
    void render(const World& world, const View& view, const Settings& settings, Film& film,
        const FrameControl& control = {});

    /// Of the last frame.
    const Stats& stats() const;

    /// Of the last frame.
    const EngineInfo& engine() const;

    /// How many threads it works on, the caller's among them.
    int threads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The instruction set the kernels use here ("AVX3", "AVX2", "SSE4", "SCALAR"), which the
/// environment variable FIRSTHIT_ISA lowers.
std::string instruction_set();

/// The version, "0.1.0".
std::string version();

} // namespace firsthit
