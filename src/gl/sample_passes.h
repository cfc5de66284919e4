// sample_passes.h - the gpu engine's passes over all samples of a section of a picture.
//
// Single pass (Robert and Schoepke 2006, section 4.2.1):
//
//     shade(...)              reads the item, intersects, shades
//
// Multi-pass (section 4.2.2):
//
//     mask_empty()            masks the samples without an item, by depth
//     find_hits(masked)       one intersection for each sample that is not masked
//     shade(stored, masked)   shades these hits
#pragma once

#include "gl/scene/gpu_data.h"
#include "gl/shadow/hit_bounds.h"
#include "gl/device/objects.h"
#include "gl/device/program.h"

#include <firsthit/film.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// Whether the ray of a sample is tested against its item, and what happens if it misses. The
/// values are those of FIRSTHIT_TEST in find_hit.glsl.
enum class HitTest {
    take_item,      // no test: the items are exact
    test_item,      // a miss leaves a hole
    try_neighbours, // after a miss, takes the nearest hit among the items around the sample
    try_all,        // always takes the nearest hit among the items around the sample
};

/// The variant of the shaders that a section needs.
struct PassVariant {
    HitTest test = HitTest::test_item;
    int item_channels = 1;    // 1: items are integers; 3, 4: items are colours, as in the paper
    bool shadow_maps = false; // false: every light reaches every point
    bool textures = false;    // whether the scene has texture coordinates
    bool uv1 = false;         // whether it has second texture coordinates
    bool colors = false;      // whether it has colours of vertices
    bool tangents = false;    // whether it has tangents
    bool few_lights = true;   // whether there are at most kFewLights
    bool environment = false; // whether there is an environment that is reflected or seen
    int only_model = -1;      // number of the only model (material/models.h); -1: several
};

/// Options of the shading pass.
struct PassInput {
    bool stored = false; // read the hits of find_hits; false: find them from the items
    bool masked = false; // skip the samples that mask_empty masked
};

struct SampleCounts {
    std::uint32_t hits = 0;
    std::uint32_t missed = 0;       // shot samples whose triangle was not found
    std::uint32_t interpolated = 0; // samples that fill_holes gave a colour
};

/// The programs and targets of the passes. All passes but the average read blocks and textures that
/// are bound as bindings.h says, and write one texel for each sample. Programs are linked when
/// first used. If there are too many, those that were not used for the longest time are deleted.
class SamplePasses {
  public:
    /// The largest number of linked programs. A frame with all planes and maps uses 18. Mesa's
    /// llvmpipe needs megabytes for each.
    static constexpr std::size_t kMostPrograms = 40;

    /// count_invocations  for tests: count the samples for which find_hits and shade run a shader
    explicit SamplePasses(bool count_invocations = false);

    /// Begins a section: uploads what its samples share, and sets its size.
    void start(const FrameData& frame, const PassVariant& variant);

    /// Masks the samples without an item.
    void mask_empty();
    /// Intersects the ray of each sample with the triangle of its item, and stores the hits.
    void find_hits(bool masked);
    /// Finds the bounds of the hits on each light's faces: see hit_bounds.h.
    void find_bounds(bool stored, std::span<LightBounds> bounds);
    /// Computes the colours.
    void shade(const PassInput& input);
    /// Gives holes the mean of the colours around them.
    void fill_holes();
    /// Averages squares of samples x samples colours: the result is the newest colours.
    void average(int samples);

    /// Counts the newest colours, or the hits of find_hits. Waits for OpenGL.
    SampleCounts count_colors() { return count(false); }
    SampleCounts count_hits() { return count(true); }

    /// Reads the newest colours, (height, width, 3) float, into rows of `row_pixels` pixels. Waits.
    void read_colors(float* to, int row_pixels);

    /// Draws one plane and reads it: aov_channels(aov) floats for each sample, or uint32 for the
    /// item.
    /// light  for Aov::lit, which has one channel here: the number of the light
    void read_plane(Aov aov, bool stored, std::size_t light, void* to, int row_pixels);

    /// The hits of find_hits, (height, width) RGBA32UI: item and the bits of t, u, v.
    const Texture2D& hits() const { return hits_; }

    /// Invocations of find_hits and shade since the last call; 0 if they are not counted.
    std::uint64_t take_invocations();

  private:
    enum class Pass { early_z, intersect, bounds, shade, fill, average, count, plane };
    const Program& linked(Pass pass, bool stored = false, int plane = 0);
    void make_room();
    SampleCounts count(bool hits);
    void draw(const Program& program, const Framebuffer& target, glm::ivec2 size);
    void draw_into(const Program& program, Texture2D& texture, GLenum format, glm::ivec2 size);

    bool count_invocations_;
    FrameData frame_data_;
    glm::ivec2 size_{0}; // size of the newest colours

    struct Linked {
        unsigned variant;       // a number for the pass and all its options
        std::uint64_t last_use; // value of uses_ at its last use
        Program program;
    };
    PassVariant variant_;
    std::vector<Linked> programs_; // at most kMostPrograms
    std::uint64_t uses_ = 0;
    VertexArray nothing_;
    Buffer frame_, invocations_, counts_;
    Texture2D mask_, hits_, colors_, filled_, pixels_;
    const Texture2D* newest_ = nullptr; // the newest of colors_, filled_ and pixels_
    std::array<Texture2D, 4> planes_;   // of the item; of 1, 2 and 4 channels
    Framebuffer target_;
    HitBounds hit_bounds_;
};

} // namespace firsthit::gl
