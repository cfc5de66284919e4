// baseline.h - the same frame by a ray tracer with a tree, to measure ours against.
#pragma once

#include <firsthit/film.h>
#include <firsthit/options/baseline_options.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <memory>
#include <string>

namespace firsthit {

/// Makes the cpu engine's frame with Embree 3: coherent packets of 8 or 16 rays from the eye; where a
/// hit's triangle faces a light, a shadow ray, in coherent packets too; then the cpu engine's own
/// shading, tile by tile, while hits are in cache. Positions are read where pose() writes them, without a copy.
///
/// The picture is the cpu engine's with exact shadows but for a few pixels: Embree rounds where rays
/// meet edges, equal depths, and shadows that begin at their own triangle.
class EmbreeBaseline {
  public:
    /// scene    is shared by the baseline and its worlds
    /// threads  0: one for each core. Trees are built by as many
    /// packet   rays in a packet: 8, over 4x2 pixels, or 16, over 4x4; 0: the most that Embree has
    ///          instructions for here
    /// throws   DeviceError: the build has no Embree, or Embree fails
    ///          ArgumentError: another number of rays
    EmbreeBaseline(
        std::shared_ptr<const Scene> scene, BaselineUpdate update, int threads = 0, int packet = 0);
    ~EmbreeBaseline();
    EmbreeBaseline(const EmbreeBaseline&) = delete;
    EmbreeBaseline& operator=(const EmbreeBaseline&) = delete;

    /// Poses the scene for the frames that follow. Counted in the next frame's statistics.
    /// throws  as firsthit::pose
    const World& pose(double time_s);

    /// The next frame's tree is updated as if everything had moved.
    void assume_moved();

    /// Makes the picture of the world that was posed last; at time 0 where none was. Of the settings
    /// color, aovs, shadows and tile_size are looked at; automatic shadows are exact.
    /// throws  ArgumentError: several samples a pixel, interleaving or shadow maps, and as
    ///         Renderer::render
    ///         DeviceError: Embree fails, for instance without memory
    void render(const View& view, const Settings& settings, Film& film);

    /// Of the last frame.
    const BaselineStats& stats() const;

    /// How many threads it works on, the caller's among them.
    int threads() const;

    /// Rays in a packet: 8 or 16.
    int packet() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// "Embree 3.13.5"; empty where the build has none.
std::string baseline_version();

} // namespace firsthit
