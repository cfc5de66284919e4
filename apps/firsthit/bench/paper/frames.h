// frames.h - measures frames of the paper's scenes, way by way in turn.
#pragma once

#include "bench/bench_options.h"
#include "bench/measure/quartiles.h"
#include "bench/paper/ways.h"

#include <firsthit/render.h>
#include <firsthit/scene.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli::bench {

/// One of the three, with the one light that the paper turns on.
struct PaperScene {
    std::string file;                   // as load_scene takes it
    std::shared_ptr<const Scene> scene; // null: it is missing
    std::string note;                   // what stands in for it, or why it is missing
    Camera camera;                      // of a scene that has none: frames it
};

/// Robots, bunny, torus. throws  as load_scene of the robots' file
std::vector<PaperScene> paper_scenes(const BenchOptions& options);

/// A view of the posed scene.
View view_of(const PaperScene& scene, const World& world, const Size& size);

/// The time of frame k of count: the middles of as many parts of the animation.
double frame_time(const Scene& scene, int k, int count);

/// Frames of one way and scene.
struct Frames {
    std::vector<double> ms;   // whole frames: the scene posed, the picture in host memory
    std::vector<Stats> stats; // of the same frames
    std::string failure;      // why there are none
};

/// What a member of the statistics says: its median.
double median_of(const Frames& frames, double Stats::*member);

/// Milliseconds of the item buffer alone: of the cpu engine boxes, bins and raster, of the gpu engine
/// upload and drawing.
std::vector<double> item_buffer_ms(const Frames& frames);

/// Renderers that stay from scene to scene, one for each way.
class PaperRenderers {
  public:
    PaperRenderers(std::vector<Way> ways, int threads);
    ~PaperRenderers();

    /// Each round is the next frame of the animation; the first two are not kept.
    /// repeats  how often the animation is gone through; its rounds follow one another
    /// done     called after each frame of a way
    /// returns  (ways), in their order
    std::vector<Frames> measure(const PaperScene& scene, const Size& size, int rounds, int repeats,
        const std::function<void()>& done);

    const std::vector<Way>& ways() const { return ways_; }
    int threads() const;

    static constexpr int kWarmUp = 2;

  private:
    struct State;
    std::vector<Way> ways_;
    std::vector<std::unique_ptr<State>> states_;
};

} // namespace firsthit::cli::bench
