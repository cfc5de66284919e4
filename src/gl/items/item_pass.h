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

/// Triangles that a format can tell apart from none.
std::uint64_t most_triangles(ItemFormat format);

/// throws  ArgumentError: more triangles than the format can tell apart
void check_triangles(ItemFormat format, std::uint64_t triangles);

/// What glReadPixels is to be asked for, 4 bytes a pixel in every format.
struct PixelLayout {
    GLenum format = GL_RED_INTEGER;
    GLenum type = GL_UNSIGNED_INT;
};
PixelLayout pixel_layout(ItemFormat format);

/// The item that a pixel of 4 bytes says; none is kNoItem in every format.
constexpr std::uint32_t decoded(ItemFormat format, std::uint32_t pixel)
{
    // rgb8 has no alpha: it is read as 255, so that none has all bits.
    if (format != ItemFormat::rgb8 || pixel == kNoItem) return pixel;
    return pixel & 0xFFFFFFu;
}

/// Draws every triangle with its number into a texture: nearest wins, at equal depth the lowest
/// number. Nothing is culled; nothing is cut near the eye or far from it. A pixel is a sample of
/// the pencil, and row 0 of the texture is the pencil's first row, the top.
///
/// source  Robert and Schoepke 2006, section 3.1
class ItemPass {
  public:
    /// throws  DeviceError: see link_program
    explicit ItemPass(const Context& context);

    /// range   of depths, for DepthFormat::fixed24 alone: see fit_depth
    /// throws  ArgumentError: more triangles than the format holds, or a pencil that is parallel
    ///         DeviceError: the pencil is wider or higher than the driver's textures, or no memory
    void draw(const SceneBuffers& scene, const Pencil& pencil, ItemFormat format, DepthFormat depth,
        const DepthRange& range = {});

    /// Of the last draw: at least as large as the pencil, whose pixels come first.
    const Texture2D& items() const { return items_; }
    const Texture2D& depth() const { return depth_; }
    /// Has both.
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
