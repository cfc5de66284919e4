// frame_maker.h - who makes the frames of a scene: one of our engines, or Embree.
#pragma once

#include "bench/baseline/scenes.h"
#include "bench/measure/in_turn.h"

#include <firsthit/baseline.h>
#include <firsthit/render.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace firsthit::cli::bench {

/// Milliseconds of each stage, in their order.
using Stages = std::vector<std::pair<std::string, double>>;

/// Milliseconds of the processor's time that the process has taken, on all threads.
double process_cpu_ms();

/// Makes frames, and keeps what they share and what they took.
class FrameMaker {
  public:
    virtual ~FrameMaker() = default;

    /// Poses the scene and makes its picture; with the items as well, for comparisons.
    void frame(double time_s, bool items = false);

    /// The same, measured. Rounds before 0 are not kept.
    /// returns  milliseconds
    double measured_frame(double time_s, int round);

    /// Median milliseconds of each stage of the rounds.
    Stages median_stages() const;

    const Film& film() const { return film_; }
    /// (rounds) milliseconds of the processor's time that the process took for the frames: other
    /// programs' turns do not count; the time of several threads is added up.
    const std::vector<double>& cpu_ms() const { return cpu_ms_; }

    static constexpr int kWarmUp = 2; // rounds that a measurement begins with

  protected:
    virtual void make(double time_s, bool items, Film& film) = 0;
    virtual Stages stages() const = 0;

  private:
    Film film_;
    std::vector<double> cpu_ms_;
    std::vector<Stages> stages_; // (rounds)
};

/// The scene has to outlive its makers.
std::unique_ptr<FrameMaker> our_frames(
    const BaselineScene& scene, const Size& size, int threads, const Settings& settings);
/// packet  0: the widest
/// throws  DeviceError as EmbreeBaseline
std::unique_ptr<FrameMaker> embree_frames(
    const BaselineScene& scene, const Size& size, int threads, BaselineUpdate update, int packet);

/// The maker's frames for measure_in_turn: a little later from round to round.
Contender contender(std::string name, const BaselineScene& scene, FrameMaker& maker);

/// The time of a round.
double round_time(const BaselineScene& scene, int round);

} // namespace firsthit::cli::bench
