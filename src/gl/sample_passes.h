// sample_passes.h - the gpu engine's passes over all samples of a part of a picture.
//
// Single pass (Robert and Schoepke 2006, section 4.2.1):
//
//     shade(...)              looks the item up, intersects, shades
//
// Multi-pass (section 4.2.2):
//
//     mask_empty()            depth, where there is an item
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

/// How a missed item is repaired: FIRSTHIT_TEST of find_hit.glsl.
enum class HitTest {
    take_item,      // items are exact: nothing is missed
    test_item,      // missed: a hole
    try_neighbours, // missed: the nearest hit among the items around
    try_all,        // the nearest hit among the items around, for every sample
};

/// Which variants of the shaders a part's samples need.
struct PassVariant {
    HitTest test = HitTest::test_item;
    int item_channels = 1;    // 1: integers; 3, 4: the paper's colours
    bool shadow_maps = false; // else every light reaches everything
    bool textures = false;    // and texture coordinates
    bool few_lights = true;   // at most kFewLights
    int only_model = -1;      // of all materials: material/models.h; -1: several
};

/// What a pass over samples goes by.
struct PassInput {
    bool stored = false; // hits are those of find_hits; else they are found again from the items
    bool masked = false; // only where mask_empty left depth
};

struct SampleCounts {
    std::uint32_t hits = 0;
    std::uint32_t missed = 0;       // of those that were shot
    std::uint32_t interpolated = 0; // by fill_holes
};

/// Programs and targets. All passes but the average read the bound blocks and textures (bindings.h)
/// and write one texel a sample. Programs are linked when first used; those not used for longest are
/// given up where there are many.
class SamplePasses {
  public:
    /// Of linked programs. A frame with all planes and maps uses 18; llvmpipe takes megabytes
    /// for one.
    static constexpr std::size_t kMostPrograms = 40;

    /// count_invocations  for tests: find_hits and shade count the samples that run their shaders
    explicit SamplePasses(bool count_invocations = false);

    /// Begins a part: uploads what its samples share, and sizes the targets.
    void start(const FrameData& frame, const PassVariant& variant);

    void mask_empty();
    void find_hits(bool masked);
    /// The rectangles that hits fill, see hit_bounds.h.
    void find_bounds(bool stored, std::span<LightBounds> bounds);
    void shade(const PassInput& input);
    /// Gives holes the colours around them.
    void fill_holes();
    /// Leaves the means of samples x samples colours.
    void average(int samples);

    /// Of the newest colours, or of the hits of find_hits. Waits.
    SampleCounts count_colors() { return count(false); }
    SampleCounts count_hits() { return count(true); }

    /// (height, width) RGB of the newest colours, to rows that are `row_pixels` long. Waits.
    void read_colors(float* to, int row_pixels);

    /// Draws one plane and reads it: float with aov_channels(aov) channels, or uint32 for the item.
    /// light  of Aov::lit, which has one channel here
    void read_plane(Aov aov, bool stored, std::size_t light, void* to, int row_pixels);

    /// (height, width) RGBA32UI: item, t, u, v of find_hits.
    const Texture2D& hits() const { return hits_; }

    /// Since the last call, of find_hits and shade. 0 where they are not counted.
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
    glm::ivec2 size_{0}; // of the newest colours

    struct Linked {
        unsigned variant;       // all that it was linked for
        std::uint64_t last_use; // a number that grows with each
        Program program;
    };
    PassVariant variant_;
    std::vector<Linked> programs_; // at most kMostPrograms: those used last
    std::uint64_t uses_ = 0;
    VertexArray nothing_;
    Buffer frame_, invocations_, counts_;
    Texture2D mask_, hits_, colors_, filled_, pixels_;
    const Texture2D* newest_ = nullptr; // of the last three
    std::array<Texture2D, 4> planes_;   // item; 1, 2 and 4 channels
    Framebuffer target_;
    HitBounds hit_bounds_;
};

} // namespace firsthit::gl
