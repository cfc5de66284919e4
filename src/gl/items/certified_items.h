// certified_items.h - an item buffer, drawn by OpenGL, that marks the samples that are uncertain.
//
// OpenGL's rasteriser does not agree exactly with rays: it snaps corners to a grid and rounds
// depths. A ray may hit the item of its pixel although OpenGL lost a nearer triangle there, so
// testing the item is not enough. Therefore two passes over all triangles test the rays themselves:
//
//   1  Each triangle is drawn as a polygon that contains all samples whose rays may hit it
//      (certify.geom). Where a ray certainly hits the triangle (hit_interval.glsl), the triangle
//      competes by the greatest depth that its hit can have. The least of these depths is kept,
//      with its triangle.
//   2  All triangles are drawn again. A sample is marked if another triangle may be hit at the kept
//      depth or nearer.
//
// If a sample is not marked, its item is proven: the ray hits it, and hits nothing nearer; or, if
// there is no item, the ray hits nothing. The caller decides marked samples exactly: see
// visibility/lazy_items.h.
#pragma once

#include "exact/cutouts.h"
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

    /// scene    posed for the pencil; its eye space must have the same bits as ViewMemory::corner
    /// cutouts  of the scene: no sample is certain of one, so each that may see one is marked
    /// throws  DeviceError: the pencil is wider or higher than the driver's textures, or no memory
    ///         ArgumentError: a parallel pencil
    void draw(const SceneBuffers& scene, const Pencil& pencil, const Cutouts& cutouts);

    /// The items of the last draw: r32ui, none = kNoItem. The texture is at least as large as the
    /// pencil, whose samples start at its first texel.
    const Texture2D& items() const { return items_; }

    /// Reads the items, (height, width) of the pencil. Waits for OpenGL.
    void read_items(std::span<std::uint32_t> items) const;

    /// The marked samples, row by row. Waits for OpenGL. Valid until the next call.
    std::span<const ListedSample> read_uncertain();

    /// Writes the items of some samples to items().
    void write(std::span<const ListedSample> samples, std::span<const std::uint32_t> items);

  private:
    struct Shader {
        Program program;
        GLint first = -1, last = -1, scale = -1, shift = -1, typical = -1, cutout_words = -1;
    };
    static Shader make_shader(bool doubts);
    void make_targets(int width, int height);
    void run(const Shader& shader, const SceneBuffers& scene, const Pencil& pencil);
    void take_cutouts(const Cutouts& cutouts);

    /// The same layout as Sample in scatter.vert.
    struct GivenItem {
        std::uint32_t pixel; // y << 16 | x
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
    Buffer cutout_buffer_;    // Cutouts::words
    GLuint cutout_words_ = 0; // 0: there are none
};

} // namespace firsthit::gl
