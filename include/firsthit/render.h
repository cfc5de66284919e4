// render.h - makes pictures of scenes.
#pragma once

#include <firsthit/film.h>
#include <firsthit/scene.h>
#include <firsthit/view.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace firsthit {

/// How a frame finds out which lights reach what it sees.
enum class Shadows {
    automatic, // exact, or map on the OpenGL engines
    none,      // every light reaches everything
    map,       // shadow maps (Robert and Schoepke 2006, section 3.2): fast, approximate
    exact,     // as a shadow ray for every sample and light would say; not on the gpu engine
};

/// Where a frame is made.
enum class Engine {
    cpu,       // our rasteriser, our rays: exact
    hybrid,    // item buffer and shadow maps by OpenGL, rays and shading on the CPU (section 4.1)
    gpu,       // everything by OpenGL (section 4.2)
    automatic, // gpu where OpenGL runs on hardware, else cpu
};

/// What the OpenGL engines do where the triangle that the item buffer names is not hit (section
/// 4.1). The cpu engine's item buffer names the triangle that is hit: it has nothing to repair.
enum class Multisample {
    none,  // nothing
    lazy3, // try the triangles of the 3 x 3 neighbourhood
    lazy5, // of 5 x 5
    full3, // try those of 3 x 3 at every pixel, the nearest hit wins
    full5, // of 5 x 5
    exact, // find the pixels that are not certain and decide them exactly: the cpu engine's items
};

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
    ItemFormat item_format = ItemFormat::r32ui;      // of the item buffer
    DepthFormat depth_format = DepthFormat::float32; // of the item buffer
    Readback readback = Readback::async;             // of the hybrid engine
    int readback_chunks = 8;                         // of the picture, 1 to 64
    GpuPasses passes = GpuPasses::single;            // of the gpu engine
};

/// What a frame is made with. Items and pictures do not depend on threads, tile size or instruction
/// set.
struct Settings {
    Engine engine = Engine::cpu;          // where the frame is made
    int samples = 1;                      // N: N x N regular rays a pixel, 1 to 16
    bool color = true;                    // false: only the planes are made
    std::vector<Aov> aovs;                // which planes to make
    int tile_size = 64;                   // pixels, a multiple of 8 from 8 to 128
    Shadows shadows = Shadows::automatic; // how lights are tested
    int shadow_map_size = 0; // texels on a side; 0: by the camera's frustum, the hits and the light
    double shadow_bias = -1; // of a map, world units towards the light; negative: by the texels
    int shadow_filter = 1;   // N: N x N texels are compared, 1 to 15; 1: hard borders
    int interleave = 1;      // N: every N-th primary ray is shot, the pixels between are
                             // interpolated (section 4.1), 1 to 16; needs samples = 1
    Multisample multisample = Multisample::lazy3; // of the OpenGL engines
    bool interpolate = true; // pixels whose triangle is not found get the colours around them
    OpenGlSettings opengl;   // of the hybrid and gpu engines
};

/// Where a frame's time went and what it counted. Milliseconds. Raster, resolve and shade run tile
/// by tile on all threads: their sum over the threads, divided by the number of threads.
struct Stats {
    double pose_ms = 0;           // scene to world
    double setup_ms = 0;          // vertices to the view, triangles to tiles
    double raster_ms = 0;         // which triangle does each sample see?
    double resolve_ms = 0;        // where exactly is it hit?
    double shadow_ms = 0;         // which lights reach what is seen; of exact shadows the parts:
    double shadow_collect_ms = 0; // hits to points in the lights' spaces
    double shadow_sort_ms = 0;    // vertices to the lights' spaces, points and triangles into cells
    double shadow_test_ms = 0;    // triangles over points
    double shade_ms = 0;          // colour and planes
    double draw_ms = 0;           // hybrid: vertices posed and triangles handed to OpenGL
    double transfer_ms = 0;       // hybrid: from there until the last item is in host memory
    double wait_ms = 0;           // hybrid: how long the rays waited for items, of the two above
    double write_ms = 0;          // filled in by who writes
    double total_ms = 0;          // the whole frame, wall clock
    std::uint64_t vertices = 0;   // of the scene
    std::uint64_t triangles = 0;  // of the scene
    std::uint64_t in_view = 0;    // triangles whose box holds a sample
    std::uint64_t tile_entries = 0;      // (triangle, tile) pairs
    std::uint64_t uncertain_lanes = 0;   // coverage that the float filter left open
    std::uint64_t ambiguous_lanes = 0;   // depth order that the float filter left open
    std::uint64_t exact_calls = 0;       // answered by expansion arithmetic
    std::uint64_t hits = 0;              // samples with an item
    std::uint64_t uncertain_samples = 0; // Multisample::exact: decided on the CPU
    std::uint64_t missed = 0;            // samples whose triangle is not found (OpenGL's items)
    std::uint64_t interpolated = 0;      // pixels that got the colours around them
    std::uint64_t shadow_points = 0;     // exact: (hit, light) pairs that a shadow ray decides
    std::uint64_t shadow_triangles = 0;  // triangles set up, once for each light and cell of points
    std::uint64_t shadow_pairs = 0;      // tests of a triangle against a point
    std::uint64_t shadow_uncertain = 0;  // of these, left open by the float filter
    std::uint64_t map_updates = 0;       // shadow maps made anew
    std::uint64_t uploaded_bytes = 0;    // of the scene to OpenGL: what is new in this frame
};

/// What a frame was made on.
struct EngineInfo {
    Engine engine = Engine::cpu; // never automatic
    std::string device;          // OpenGL's renderer and version; empty: none was used
    std::string reason;          // of Engine::automatic: why it is this one; else empty
};

/// Renders frames; keeps the memory that they share. One frame at a time. The OpenGL engines have a
/// context of their own, which is current on the caller's thread only inside of render(), where it takes
/// the place of the caller's: so frames may come from different threads.
///
/// limits  after fork(), a child makes a renderer of its own and keeps to the cpu engine: drivers'
///         threads stay with the parent
///         the OpenGL engines take rigid parts from the scene and World::node_matrix, the others from
///         World::position: positions that the caller changed after pose() are not seen
class Renderer {
  public:
    /// threads  0: one for each core
    explicit Renderer(int threads = 0);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Poses the scene and makes the picture. A film's memory is reused by the next call that is
    /// given the same film.
    /// throws  ArgumentError: a size, region, sample count, camera or shadow setting out of range,
    ///         Aov::lit of a world without lights or with more than kMaxLitLights
    ///         SceneError: a light that contradicts itself
    ///         DeviceError: an OpenGL engine that is not there, or fails: no OpenGL 4.5, too little
    ///         memory, a lost context. The next frame starts anew. Engine::automatic takes the cpu
    ///         engine instead
    void render(
        const Scene& scene, double time_s, const View& view, const Settings& settings, Film& film);

    /// Poses the scene on the renderer's threads, for render() with a world: who wants the camera
    /// of that time first. Counted in the next frame's statistics.
    /// throws  as firsthit::pose
    void pose(const Scene& scene, double time_s, World& world);

    /// Makes the picture of a world that is posed already.
    /// throws  as the first render
    void render(const World& world, const View& view, const Settings& settings, Film& film);

    /// Of the last frame.
    const Stats& stats() const;

    /// Of the last frame.
    const EngineInfo& engine() const;

    /// How many threads it works on, the caller's among them.
    int threads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The instruction set the kernels use here ("AVX3", "AVX2", "SSE4", "SCALAR"), which the
/// environment variable FIRSTHIT_ISA lowers.
std::string instruction_set();

/// The version, "0.1.0".
std::string version();

} // namespace firsthit
