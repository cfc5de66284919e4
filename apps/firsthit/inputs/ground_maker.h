// ground_maker.h - puts a floor under the scenes of a run (--ground).
#pragma once

#include "options/render_options.h"

#include <firsthit/ground.h>

#include <mutex>
#include <optional>

namespace firsthit::cli {

/// Puts the same floor under all scenes of a run: under the lowest point of the first one at the first frame.
/// The cameras frame that one before it has a floor. Threads may share it.
class GroundMaker {
  public:
    /// options  outlive it
    /// views    of the run; it is asked for the first view
    GroundMaker(const RenderOptions& options, std::optional<ViewMaker>& views)
        : options_(options),
          views_(views)
    {
    }

    /// throws  as pose and frames_of
    void add(Scene& scene);

  private:
    /// The floor of a scene that has none yet.
    Ground find(Scene& scene);

    const RenderOptions& options_;
    std::optional<ViewMaker>& views_;
    std::mutex mutex_;
    std::optional<Ground> ground_;
};

} // namespace firsthit::cli
