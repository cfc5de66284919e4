// certified_items.h - an item buffer by OpenGL that knows where it is not certain.
//
// OpenGL's coverage is not the rays': corners snap to a grid, and depth is rounded. A wrong item may
// well be hit by its ray, while a nearer triangle was lost; the pixel alone does not tell. So two
// passes over all triangles ask the ray itself:
//
//   1  Every triangle is drawn as a polygon that holds all samples it may hit (certify.geom). Where
//      float is sure that the ray hits it (hit_interval.glsl), it competes by the farthest depth
//      that its hit may have. The nearest is kept, with that depth.
//   2  All triangles again: whoever else may be hit no farther than that marks the sample.
//
// A sample without a mark is proven: its item is hit, and whatever else is hit lies behind it; or,
// where there is no item, nothing is hit. Marked samples are decided exactly by the caller, see
// visibility/lazy_items.h.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"
#include "gl/items/triangle_draw.h"
#include "visibility/lazy_items.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

class CertifiedItems {
  public:
    /// throws  DeviceError: see link_program
    explicit CertifiedItems(const Context& context);

    /// scene   posed for the pencil with eye space that has the bits of ViewMemory::corner
    /// throws  DeviceError: the pencil is wider or higher than the driver's textures, or no memory
    ///         ArgumentError: a parallel pencil
    void draw(const SceneBuffers& scene, const Pencil& pencil);

    /// Of the last draw: r32ui, none = kNoItem; at least as large as the pencil, whose pixels come
    /// first.
    const Texture2D& items() const { return items_; }

    /// (height, width) of the pencil. Waits.
    void read_items(std::span<std::uint32_t> items) const;

    /// The samples that are marked, row by row. Waits; valid until the next call.
    std::span<const ListedSample> read_uncertain();

    /// Writes the items of samples into items().
    void write(std::span<const ListedSample> samples, std::span<const std::uint32_t> items);

  private:
    struct Shader {
        Program program;
        GLint first = -1, last = -1, scale = -1, shift = -1, typical = -1;
    };
    static Shader make_shader(bool doubts);
    void make_targets(int width, int height);
    void run(const Shader& shader, const SceneBuffers& scene, const Pencil& pencil);

    /// As scatter.vert has it.
    struct GivenItem {
        std::uint32_t place; // y << 16 | x
        std::uint32_t item;
    };

    ContextInfo limits_;
    Shader sure_, doubt_;
    TriangleDraw triangles_;
    Texture2D items_, depths_, key_, uncertain_;
    Framebuffer sure_target_, doubt_target_, item_target_;
    int width_ = 0, height_ = 0; // of the pencil

    std::vector<std::uint8_t> marks_; // (height, width)
    std::vector<ListedSample> listed_;
    Program scatter_;
    VertexArray nothing_;
    std::vector<GivenItem> given_;
    Buffer given_buffer_;
};

} // namespace firsthit::gl
