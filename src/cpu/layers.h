// layers.h - frames of scenes with blended surfaces: all that a sample's ray hits in front of what is
// opaque counts, front to back.
#pragma once

#include "base/buffer.h"
#include "frame/frame_context.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/lazy_items.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace firsthit {

struct FrameMemory;
struct FrameSources;

/// The memory of render_layers, kept from frame to frame.
struct LayerMemory {
    Film film;                       // the colours of one layer
    Film seen;                       // the items of the first one
    EyeMesh mesh;                    // of a part of the picture
    LazyMemory lazy;                 //
    Buffer<std::uint32_t> item;      // (height, width) of the samples: the layer's, or kNoItem
    Buffer<float> through;           // (height, width) share of what lies behind that is seen
    Buffer<glm::vec3> sum;           // (height, width) of the layers so far
    Buffer<float> behind;            // (height, width) share of the background that is seen
    std::vector<ListedSample> open;  // of a part: samples that have a next layer
    std::vector<std::uint32_t> last; // (open) their layer's items
};

/// Whether the frame shows layers: the scene has blended triangles, and colours are made of every
/// pixel.
bool has_layers(const World& world, const Settings& settings);

/// As render_frame, for a frame that shows layers. The layers of a sample are all that its ray hits,
/// in exact order (t, then id), up to the first that is opaque; cut-outs with AlphaMode::mask are
/// there or not. Each is shaded as a frame of its own, and counts with its opacity, times what the
/// layers before it let through. Planes are those of the first layer: the first surface of any
/// opacity above 0.
///
/// limits  N x N samples a pixel are rendered as a picture N times as wide and high, whose rays may
///         differ from those of opaque scenes by a rounding. Where less than 2^-24 is let through,
///         what lies behind is left out
void render_layers(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources);

} // namespace firsthit
