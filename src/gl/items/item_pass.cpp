// item_pass.cpp - item buffers drawn by OpenGL.
#include "gl/items/item_pass.h"

#include "gl/device/program.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::gl {
namespace {

/// The distance that has depth 1 in the reversed float buffer. Depths keep all their bits from here
/// to 2^126 times as far, 8e25. Nearer points are clamped to this distance.
constexpr float kNearest = 0x1p-40f;

const char* name_of(ItemFormat format)
{
    switch (format) {
    case ItemFormat::rgb8:
        return "rgb8";
    case ItemFormat::rgba8:
        return "rgba8";
    default:
        return "r32ui";
    }
}

GLenum texture_format(ItemFormat format)
{
    switch (format) {
    case ItemFormat::rgb8:
        return GL_RGB8;
    case ItemFormat::rgba8:
        return GL_RGBA8;
    default:
        return GL_R32UI;
    }
}

} // namespace

std::uint64_t most_triangles(ItemFormat format)
{
    return (std::uint64_t(1) << (format == ItemFormat::rgb8 ? 24 : 32)) - 1;
}

void check_triangles(ItemFormat format, std::uint64_t triangles)
{
    if (triangles > most_triangles(format))
        throw ArgumentError(
            fmt::format("{} triangles are too many for the item format {}: it holds {}", triangles,
                name_of(format), most_triangles(format)));
}

PixelLayout pixel_layout(ItemFormat format)
{
    if (format == ItemFormat::r32ui) return {};
    return {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV}; // red is the lowest byte
}

ItemPass::ItemPass(const Context& context)
    : limits_(context.info()),
      integers_(make_shader(false)),
      colors_(make_shader(true))
{
}

ItemPass::Shader ItemPass::make_shader(bool colors)
{
    Shader shader;
    shader.program =
        link_program({"item.vert", "item.frag"}, Defines{{"COLORS", colors ? "1" : "0"}});
    shader.scale = shader.program.location("scale");
    shader.shift = shader.program.location("shift");
    shader.depth = shader.program.location("depth");
    return shader;
}

/// Makes the textures large enough. As long as their formats stay the same they never shrink.
void ItemPass::make_target(GLenum format, GLenum depth_format)
{
    const bool same = items_.format() == format && depth_.format() == depth_format;
    if (same && items_.width() >= width_ && items_.height() >= height_) return;
    const int width = same ? std::max(width_, items_.width()) : width_;
    const int height = same ? std::max(height_, items_.height()) : height_;
    items_.resize(format, width, height);
    depth_.resize(depth_format, width, height);
    framebuffer_.attach(GL_COLOR_ATTACHMENT0, items_.name());
    framebuffer_.attach(GL_DEPTH_ATTACHMENT, depth_.name());
    framebuffer_.check_complete("items");
}

void ItemPass::draw(const SceneBuffers& scene, const Pencil& pencil, ItemFormat format,
    DepthFormat depth, const DepthRange& range)
{
    check_triangles(format, scene.triangles());
    check_pencil(pencil, limits_);
    format_ = format;
    width_ = pencil.width;
    height_ = pencil.height;
    const bool reversed = depth == DepthFormat::float32;
    make_target(texture_format(format), reversed ? GL_DEPTH_COMPONENT32F : GL_DEPTH_COMPONENT24);

    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
    glScissor(0, 0, width_, height_);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER); // which would change the bytes of colours
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    // Depth grows towards the eye in both formats. Later triangles of equal depth lose.
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    glEnable(GL_DEPTH_CLAMP);
    // Row 0 of the texture is the top row of the picture.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);

    const GLuint none[4] = {kNoItem, kNoItem, kNoItem, kNoItem};
    const GLfloat white[4] = {1, 1, 1, 1};
    const GLfloat farthest = 0;
    if (format == ItemFormat::r32ui)
        glClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 0, none);
    else
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, white);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &farthest);

    if (scene.triangles() > 0) {
        const Shader& shader = format == ItemFormat::r32ui ? integers_ : colors_;
        shader.program.use();
        const SampleToClip clip = sample_to_clip(pencil);
        glUniform2fv(shader.scale, 1, clip.scale);
        glUniform2fv(shader.shift, 1, clip.shift);
        // float32: nearest / z; fixed24: 1 at near, 0 at far.
        const double span = range.far - range.near;
        if (reversed)
            glUniform2f(shader.depth, kNearest, 0);
        else
            glUniform2f(
                shader.depth, GLfloat(range.near * range.far / span), GLfloat(-range.near / span));
        triangles_.draw(scene);
        glUseProgram(0);
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_CLAMP);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    check("drawing items");
}

} // namespace firsthit::gl
