// settings.h - what a frame is made with.
#pragma once

#include <firsthit/film.h>
#include <firsthit/options/multisample.h>
#include <firsthit/options/opengl_options.h>
#include <firsthit/options/shadow_options.h>

#include <vector>

namespace firsthit {

/// Where a frame is made.
enum class Engine {
    cpu,       // our rasteriser, our rays: exact
    hybrid,    // item buffer and shadow maps by OpenGL, rays and shading on the CPU (section 4.1)
    gpu,       // everything by OpenGL (section 4.2)
    automatic, // gpu where OpenGL runs on hardware, else cpu
};

/// What a frame is made with: settings.shadows and the like are those of ShadowOptions. Items and
/// pictures do not depend on threads, tile size or instruction set.
struct Settings : ShadowOptions {
    Engine engine = Engine::cpu; // where the frame is made
    int samples = 1;             // N: N x N regular rays a pixel, 1 to 16
    bool color = true;           // false: only the planes are made
    std::vector<Aov> aovs;       // which planes to make
    int tile_size = 64;          // pixels, a multiple of 8 from 8 to 128
    int interleave = 1;          // N: every N-th primary ray is shot, the pixels between are
                                 // interpolated (section 4.1), 1 to 16; needs samples = 1
    Multisample multisample = Multisample::lazy3; // of the OpenGL engines
    bool interpolate = true; // pixels whose triangle is not found get the colours around them
    OpenGlSettings opengl;   // of the hybrid and gpu engines
};

} // namespace firsthit
