// frame_context.h - what all stages of a frame share.
#pragma once

#include "base/pixel_steps.h"
#include "base/tasks.h"
#include "frame/frame_progress.h"

#include <firsthit/film.h>
#include <firsthit/scene.h>
#include <firsthit/view.h>

namespace firsthit {

struct FrameContext {
    const World& world;
    const View& view; // checked, its region is filled in
    Tasks& tasks;
    Film& film;
    FrameProgress* progress = nullptr; // null: progress is not reported
    PixelSteps steps = {}; // between the pixels of the frame: then the film is theirs, and
                           // the view's region is counted in steps

    /// These call the functions of FrameProgress, if there is one.
    void begin(std::uint64_t work) const
    {
        if (progress) progress->begin(work);
    }
    void add(std::uint64_t work, std::size_t worker) const
    {
        if (progress) progress->add(work, worker);
    }
};

} // namespace firsthit
