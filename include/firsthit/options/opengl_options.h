// opengl_options.h - what is done by OpenGL, and how.
#pragma once

namespace firsthit {

/// How triangle ids are written by OpenGL.
enum class ItemFormat {
    r32ui, // an integer for each pixel
    rgb8,  // colours: at most 2^24 - 1 triangles
    rgba8, // colours: at most 2^32 - 1 triangles
};

/// The depth buffer of the item buffer on OpenGL.
enum class DepthFormat {
    float32, // reversed: 1 / z, no far plane
    fixed24, // between planes that are fitted to the scene
};

/// How items come from OpenGL to the hybrid engine's rays.
enum class Readback {
    sync,  // the picture at once; nothing else happens meanwhile
    async, // in chunks through pixel buffer objects; rays start with the first chunk
};

/// How the gpu engine shades.
enum class GpuPasses {
    single, // one pass over all pixels (section 4.2.1)
    multi,  // pixels without an item are masked by depth; then intersection, then shading (4.2.2)
};

/// What is done by OpenGL, and how.
struct OpenGlSettings {
    ItemFormat item_format = ItemFormat::r32ui;
    DepthFormat depth_format = DepthFormat::float32;
    Readback readback = Readback::async;
    int readback_chunks = 8; // of the picture, 1 to 64
    GpuPasses passes = GpuPasses::single;
};

} // namespace firsthit
