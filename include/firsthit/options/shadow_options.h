// shadow_options.h - options of shadows.
#pragma once

namespace firsthit {

/// The technique by which a frame finds the lights that reach a point.
enum class Shadows {
    automatic, // exact on the cpu engine, map on the OpenGL engines
    none,      // no shadows: every light reaches every point
    map,       // shadow maps (Robert and Schoepke 2006, section 3.2): fast, approximate
    exact,     // one exact shadow ray for each sample and light; not on the gpu engine
};

struct ShadowOptions {
    Shadows shadows = Shadows::automatic; // the technique
    int shadow_map_size = 0; // longer side of maps, texels, 16 to 8192; 0: chosen from the hits
    double shadow_bias = -1; // of maps, world units along the map's axis; negative: slope bias
    int shadow_filter = 1;   // N: averages N x N depth comparisons, 1 to 15; 1: hard edges
};

} // namespace firsthit
