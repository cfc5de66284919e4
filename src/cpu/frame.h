// frame.h - the frame of the cpu engine: renders a posed world tile by tile.
#pragma once

#include "cpu/frame_memory.h"
#include "frame/frame_context.h"
#include "visibility/item_source.h"

#include <firsthit/settings.h>
#include <firsthit/stats.h>

namespace firsthit {

class EdgeFinder;
struct PixelMarks;

/// Where the items and the shadow maps of a frame come from. The cpu engine makes what is null.
struct FrameSources {
    ItemSource* items = nullptr;
    MapMaker* maps = nullptr;
    /// Looks for edges in what the rays of colour see; null: nothing does (cpu/adaptive/).
    EdgeFinder* edges = nullptr;
    /// The only pixels whose samples are found, by the rasteriser, and shaded; null: all are. Other
    /// pixels of a film that has its size already, and its planes but colour, stay as they are.
    const PixelMarks* only = nullptr;
};

/// Renders the view's region into the film, and adds to the statistics.
///
/// frame     its view is checked (render/check_settings.h); the film is resized to its region
/// settings  checked; Shadows::automatic means exact
/// memory    kept from frame to frame, so that nothing is allocated once sizes have settled
/// throws    Cancelled if a stop was requested. Then the film has its size, and the memory can be
///           used for the next frame as if this one had never begun
void render_frame(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources = {});

/// The same, of what each sample sees first: blended surfaces (cpu/layers.h) are opaque.
void render_surfaces(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources);

} // namespace firsthit
