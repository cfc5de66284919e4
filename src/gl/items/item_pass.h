// item_pass.h - item buffers drawn by OpenGL.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/items/fit_depth.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"
#include "gl/items/triangle_draw.h"

#include <firsthit/options/opengl_options.h>

#include <cstdint>

namespace firsthit::gl {

/// The largest number of triangles that a format can hold, besides kNoItem.
std::uint64_t most_triangles(ItemFormat format);

/// throws  ArgumentError: more triangles than the format can hold
void check_triangles(ItemFormat format, std::uint64_t triangles);

/// The arguments of glReadPixels. A pixel has 4 bytes in every format.
struct PixelLayout {
    GLenum format = GL_RED_INTEGER;
    GLenum type = GL_UNSIGNED_INT;
};
PixelLayout pixel_layout(ItemFormat format);

/// The item of a pixel of 4 bytes; kNoItem for the background in every format.
constexpr std::uint32_t decoded(ItemFormat format, std::uint32_t pixel)
{
    // rgb8 has no alpha, which is read as 255. So the background still reads as kNoItem.
    if (format != ItemFormat::rgb8 || pixel == kNoItem) return pixel;
    return pixel & 0xFFFFFFu;
}

/// Draws the number of each triangle to a texture. The nearest triangle wins; at equal depths the
/// lowest number wins. Triangles are neither culled nor clipped by a near or far plane. A pixel is
/// a sample of the pencil. Row 0 of the texture is the top row.
///
/// source  Robert and Schoepke 2006, section 3.1
class ItemPass {
  public:
    /// throws  DeviceError: see link_program
    explicit ItemPass(const Context& context);

    /// range   of depths, used by DepthFormat::fixed24 only: see fit_depth
    /// throws  ArgumentError: more triangles than the format holds, or a pencil that is parallel
    ///         DeviceError: the pencil is wider or higher than the driver's textures, or no memory
    void draw(const SceneBuffers& scene, const Pencil& pencil, ItemFormat format, DepthFormat depth,
        const DepthRange& range = {});

    /// The items of the last draw. The texture is at least as large as the pencil, whose samples
    /// start at its first texel.
    const Texture2D& items() const { return items_; }
    const Texture2D& depth() const { return depth_; }
    /// The framebuffer of both textures.
    const Framebuffer& framebuffer() const { return framebuffer_; }
    ItemFormat format() const { return format_; }
    int width() const { return width_; } // of the pencil
    int height() const { return height_; }

  private:
    struct Shader {
        Program program;
        GLint scale = -1, shift = -1, depth = -1;
    };
    static Shader make_shader(bool colors);
    void make_target(GLenum format, GLenum depth_format);

    ContextInfo limits_;
    Shader integers_, colors_;
    TriangleDraw triangles_;
    Texture2D items_, depth_;
    Framebuffer framebuffer_;
    ItemFormat format_ = ItemFormat::r32ui;
    int width_ = 0, height_ = 0;
};

} // namespace firsthit::gl
