// shadow_options.h - how a frame finds out which lights reach what it sees.
#pragma once

namespace firsthit {

/// How a frame finds out which lights reach what it sees.
enum class Shadows {
    automatic, // exact, or map on the OpenGL engines
    none,      // every light reaches everything
    map,       // shadow maps (Robert and Schoepke 2006, section 3.2): fast, approximate
    exact,     // as a shadow ray for every sample and light would say; not on the gpu engine
};

struct ShadowOptions {
    Shadows shadows = Shadows::automatic;
    int shadow_map_size = 0; // texels on a side; 0: by the camera's frustum, the hits and the light
    double shadow_bias = -1; // of a map, world units towards the light; negative: by the texels
    int shadow_filter = 1;   // N: N x N texels are compared, 1 to 15; 1: hard borders
};

} // namespace firsthit
