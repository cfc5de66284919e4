// frame.h - the cpu engine: a picture from a posed world, tile by tile.
#pragma once

#include "cpu/frame_memory.h"
#include "frame/frame_context.h"
#include "visibility/item_source.h"

#include <firsthit/settings.h>
#include <firsthit/stats.h>

namespace firsthit {

/// Who makes what a frame is made of; null: the cpu engine.
struct FrameSources {
    ItemSource* items = nullptr;
    MapMaker* maps = nullptr;
};

/// Renders the view's region into the film and adds to the statistics. `settings` and the frame's
/// view are checked (render/check_settings.h). Shadows::automatic is exact.
/// throws  Cancelled: the film has its size, and the memory serves the next frame as if this one had
///         never begun
void render_frame(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources = {});

} // namespace firsthit
