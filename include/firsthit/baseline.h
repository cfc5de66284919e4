// baseline.h - the same frame made with Embree's ray tracer, to measure ours against.
#pragma once

#include <firsthit/film.h>
#include <firsthit/options/baseline_options.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <memory>
#include <string>

namespace firsthit {

/// Makes the cpu engine's frame with Embree 3. Rays from the eye are traced in coherent packets of
/// 8 or 16. If the triangle of a hit faces a light, a shadow ray is traced, also in coherent
/// packets. Then the cpu engine's shading follows, tile by tile, while the hits are in cache.
/// Embree reads the positions where pose() writes them, without a copy.
///
/// The picture differs from the cpu engine's picture with exact shadows in a few pixels, because
/// Embree rounds: at edges, at equal depths, and at shadows that begin at their own triangle.
class EmbreeBaseline {
  public:
    /// scene    shared by the baseline and its worlds
    /// threads  number of threads for rendering and for building trees; 0: one for each core
    /// packet   rays in a packet: 8 (4x2 pixels) or 16 (4x4 pixels); 0: the most that Embree
    ///          supports on this machine
    /// throws   DeviceError: the build has no Embree, or Embree fails
    ///          ArgumentError: another packet size
    EmbreeBaseline(
        std::shared_ptr<const Scene> scene, BaselineUpdate update, int threads = 0, int packet = 0);
    ~EmbreeBaseline();
    EmbreeBaseline(const EmbreeBaseline&) = delete;
    EmbreeBaseline& operator=(const EmbreeBaseline&) = delete;

    /// Poses the scene for the following frames, at a time in seconds. The time that it takes is
    /// part of the next frame's statistics.
    /// throws  as firsthit::pose
    const World& pose(double time_s);

    /// Makes the next frame update its tree as if all triangles had moved.
    void assume_moved();

    /// Makes the picture of the world that was posed last; poses it at time 0 if it was never
    /// posed. Uses settings.color, aovs, shadows and tile_size only; automatic shadows are exact.
    /// throws  ArgumentError: several samples in a pixel, interleaving, a sky or shadow maps, and as
    ///         Renderer::render
    ///         DeviceError: Embree fails, for example because there is not enough memory
    void render(const View& view, const Settings& settings, Film& film);

    /// Statistics of the last frame.
    const BaselineStats& stats() const;

    /// The number of threads, including the caller's.
    int threads() const;

    /// Rays in a packet: 8 or 16.
    int packet() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The version of Embree, such as "Embree 3.13.5"; empty if the build has none.
std::string baseline_version();

} // namespace firsthit
