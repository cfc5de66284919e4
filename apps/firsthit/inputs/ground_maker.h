// ground_maker.h - puts a floor under the scenes of a run (--ground).
#pragma once

#include "options/render_options.h"

#include <firsthit/ground.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace firsthit::cli {

/// Puts the same floor under all scenes of a run: under the lowest point of the first frame. The cameras frame that
/// one before it has a floor. Threads may share it.
class GroundMaker {
  public:
    /// options  outlive it
    /// views    of the run; it is asked for the first view
    GroundMaker(const RenderOptions& options, std::optional<ViewMaker>& views)
        : options_(options),
          views_(views)
    {
    }

    /// Finds the floor of numbered files, whose first frame may lie between two of them; of a single file, add does.
    /// change  what is done to every scene before it gets a floor
    /// throws  as open_scene, pose and frames_of
    void look_at_first_frame(const std::function<void(Scene&)>& change);

    /// throws  as pose and frames_of
    void add(Scene& scene);

  private:
    /// The floor of a scene that has none yet.
    Ground find(const std::shared_ptr<const Scene>& scene);

    /// The time of the run's first frame.
    double first_time_s(const Scene& scene) const;

    const RenderOptions& options_;
    std::optional<ViewMaker>& views_;
    std::mutex mutex_;
    std::optional<Ground> ground_;
};

} // namespace firsthit::cli
