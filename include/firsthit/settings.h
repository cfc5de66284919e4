// settings.h - the settings of a frame.
#pragma once

#include <firsthit/film.h>
#include <firsthit/options/multisample.h>
#include <firsthit/options/opengl_options.h>
#include <firsthit/options/shadow_options.h>
#include <firsthit/options/sky_options.h>
#include <firsthit/view.h>

#include <vector>

namespace firsthit {

struct World;

/// The frame before, from which the planes `motion` and `motion_visible` are counted.
struct PreviousFrame {
    const World* world =
        nullptr;     // the same scene at another time, used only during the frame; null:
                     // nothing moved, and what is seen was visible
    Camera camera{}; // of that frame, whose picture has the size of this one
};

/// The engines. Sections refer to Robert and Schoepke 2006 (docs/sources.md).
enum class Engine {
    cpu,       // everything on the CPU: exact
    hybrid,    // items and shadow maps by OpenGL, rays and shading on the CPU (section 4.1)
    gpu,       // everything by OpenGL (section 4.2)
    automatic, // gpu if OpenGL runs on hardware and shadows are not exact, else cpu
};

/// The settings of a frame, including those of shadows, which are inherited from ShadowOptions.
/// Items and pictures do not depend on the number of threads, the tile size or the instruction set.
struct Settings : ShadowOptions {
    Engine engine = Engine::cpu; // the engine that makes the frame
    int samples = 1;             // N: N x N rays in each pixel on a regular grid, 1 to 16
    /// N: one ray a pixel, and the colour of N x N rays, as with samples = N, where a pixel may hold an
    /// edge: another surface, a crease, the border of a shadow, or contrast. 1 to 16; 1: nowhere. Needs
    /// samples = 1 and interleave = 1. Planes stay those of one ray. N = 4 takes 2.5 to 6 times as long
    /// as one ray a pixel, most where textures fill the picture. The gpu engine ignores it
    int adaptive = 1;
    bool color = true;     // false: makes only the planes
    bool alpha = false;    // also makes Film::alpha: the share of the pixel's samples that see a
                           // surface, what blended surfaces let through left out. Colours are
                           // not divided by it, and hold Scene::background where it is below 1
    std::vector<Aov> aovs; // the planes to make
    int tile_size = 64;    // pixels, a multiple of 8 from 8 to 128
    int interleave = 1;    // N: shoots one primary ray in N pixels and interpolates the pixels
                           // between (section 4.1); 1, 2, 4, 8 or 16; needs samples = 1
    Multisample multisample = Multisample::lazy3; // item repair of the OpenGL engines
    bool interpolate = true; // fills pixels whose triangle is not found from the pixels around them
    Sky sky;                 // light from all of the sky; off by default
    OpenGlSettings opengl;   // options of the hybrid and gpu engines
    PreviousFrame previous;  // where the plane `motion` begins
};

} // namespace firsthit
