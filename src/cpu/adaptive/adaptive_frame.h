// adaptive_frame.h - frames with N x N samples where a pixel may hold an edge.
#pragma once

#include "cpu/adaptive/edge_memory.h"
#include "cpu/adaptive/pixel_marks.h"
#include "frame/frame_context.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>

namespace firsthit {

struct FrameMemory;
struct FrameSources;

/// Memory that is kept from frame to frame.
struct AdaptiveMemory {
    EdgeMemory edges;
    PixelMarks marks;
    Film film; // of a region and the pixels around it, or of a section with layers
    Settings coarse, fine;
};

/// Whether the settings ask for such a frame.
bool wants_edges(const Settings& settings);

/// As render_frame. Makes the frame of one sample a pixel, marks the pixels that may hold an edge
/// (edge_finder.h), and gives these the colour of N x N samples: the samples of a frame with
/// Settings::samples = N, found, lit and shaded by the same functions, and their mean in the same
/// order. So the colours of marked pixels have the bits of that frame, and the others those of the
/// frame of one sample. All planes but colour are those of one sample.
///
/// sources  are for the frame of one sample. More samples are rasterised, and shadow maps are made anew
///          for them, which may differ from those of all N x N samples
/// limits   all marks of a region's pixels are those of the whole picture, because pixels around the
///          region are rendered as well
void render_adaptively(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources);

} // namespace firsthit
