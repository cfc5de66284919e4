// coverage.h - the share of each pixel's samples that see a surface.
#pragma once

#include "cpu/frame.h"
#include "frame/frame_context.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>

namespace firsthit {

/// Makes Film::alpha from the items of all samples. The items are the cpu engine's, whichever engine made the
/// colours.
class Coverage {
  public:
    /// Fills the film's alpha.
    ///
    /// frame     with its region filled in, and the film of its size
    /// settings  that passed check_settings.h
    void fill(const FrameContext& frame, const Settings& settings);

  private:
    FrameMemory memory_;
    Film items_; // of some rows
};

} // namespace firsthit
