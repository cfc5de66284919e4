// opengl_options.h - options of the OpenGL engines. Sections refer to Robert and Schoepke 2006.
#pragma once

namespace firsthit {

/// The format in which OpenGL draws triangle ids.
enum class ItemFormat {
    r32ui, // integers: at most 2^32 - 1 triangles
    rgb8,  // colours: at most 2^24 - 1 triangles
    rgba8, // colours: at most 2^32 - 1 triangles
};

/// The depth buffer that OpenGL uses to draw items.
enum class DepthFormat {
    float32, // reversed float depth, 1 / z, without near and far planes
    fixed24, // 24-bit integers between near and far planes that are fitted to the scene
};

/// How the hybrid engine transfers items from OpenGL to host memory.
enum class Readback {
    sync,  // the whole picture at once, while the CPU waits
    async, // in chunks through pixel buffer objects; the CPU starts with the first chunk
};

/// The shading passes of the gpu engine.
enum class GpuPasses {
    single, // one pass over all pixels (section 4.2.1)
    multi,  // masks pixels without an item by depth, then intersects, then shades (4.2.2)
};

/// Options of the OpenGL engines.
struct OpenGlSettings {
    ItemFormat item_format = ItemFormat::r32ui;
    DepthFormat depth_format = DepthFormat::float32;
    Readback readback = Readback::async;
    int readback_chunks = 8; // number of chunks for Readback::async, 1 to 64
    GpuPasses passes = GpuPasses::single;
};

} // namespace firsthit
