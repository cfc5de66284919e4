// certified_items.cpp - an item buffer, drawn by OpenGL, that marks the samples that are uncertain.
#include "gl/items/certified_items.h"

#include "gl/bindings.h"
#include "gl/device/program.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace firsthit::gl {

CertifiedItems::CertifiedItems(const Context& context)
    : limits_(context.info()),
      sure_(make_shader(false)),
      doubt_(make_shader(true)),
      scatter_(link_program({"scatter.vert", "scatter.frag"}))
{
    nothing_.create();
}

CertifiedItems::Shader CertifiedItems::make_shader(bool doubts)
{
    Shader shader;
    shader.program = link_program(
        {"certify.vert", "certify.geom", "certify.frag"}, Defines{{"DOUBTS", doubts ? "1" : "0"}});
    shader.first = shader.program.location("first");
    shader.last = shader.program.location("last");
    shader.scale = shader.program.location("scale");
    shader.shift = shader.program.location("shift");
    shader.typical = shader.program.location("typical");
    shader.cutout_words = shader.program.location("cutout_words");
    return shader;
}

void CertifiedItems::make_targets(int width, int height)
{
    if (items_.width() >= width && items_.height() >= height) return;
    width = std::max(width, items_.width());
    height = std::max(height, items_.height());
    items_.resize(GL_R32UI, width, height);
    depths_.resize(GL_R32F, width, height);
    key_.resize(GL_DEPTH_COMPONENT32F, width, height);
    uncertain_.resize(GL_R8UI, width, height);
    sure_target_.attach(GL_COLOR_ATTACHMENT0, items_.name());
    sure_target_.attach(GL_COLOR_ATTACHMENT1, depths_.name());
    sure_target_.attach(GL_DEPTH_ATTACHMENT, key_.name());
    const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(sure_target_.name(), 2, both);
    sure_target_.check_complete("certain items");
    doubt_target_.attach(GL_COLOR_ATTACHMENT0, uncertain_.name());
    doubt_target_.check_complete("uncertain samples");
    item_target_.attach(GL_COLOR_ATTACHMENT0, items_.name());
    item_target_.check_complete("items that are given");
}

void CertifiedItems::run(const Shader& shader, const SceneBuffers& scene, const Pencil& pencil)
{
    if (scene.triangles() == 0) return;
    shader.program.use();
    const double width = pencil.width, height = pencil.height;
    glUniform2f(shader.first, GLfloat(pencil.x0), GLfloat(pencil.y0));
    glUniform2f(shader.last, GLfloat(pencil.x0 + width - 1), GLfloat(pencil.y0 + height - 1));
    const SampleToClip clip = sample_to_clip(pencil);
    glUniform2fv(shader.scale, 1, clip.scale);
    glUniform2fv(shader.shift, 1, clip.shift);
    glUniform1f(shader.typical, 1);
    glUniform1ui(shader.cutout_words, cutout_words_);
    if (cutout_words_ > 0) cutout_buffer_.bind_storage(kCutoutsBlock);
    triangles_.draw(scene);
    glUseProgram(0);
}

void CertifiedItems::take_cutouts(const Cutouts& cutouts)
{
    cutout_words_ = GLuint(2 * cutouts.words().size()); // of 32 bits
    if (cutouts.any()) cutout_buffer_.assign(cutouts.words());
}

void CertifiedItems::draw(const SceneBuffers& scene, const Pencil& pencil, const Cutouts& cutouts)
{
    check_pencil(pencil, limits_);
    take_cutouts(cutouts);
    make_targets(pencil.width, pencil.height);
    width_ = pencil.width;
    height_ = pencil.height;
    glViewport(0, 0, pencil.width, pencil.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    // Row 0 of the texture is the top row of the picture.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);

    const GLuint none[4] = {kNoItem, kNoItem, kNoItem, kNoItem}, zero[4] = {0, 0, 0, 0};
    const GLfloat nowhere[4] = {std::numeric_limits<float>::infinity(), 0, 0, 0};
    const GLfloat farthest = 0;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sure_target_.name());
    glClearNamedFramebufferuiv(sure_target_.name(), GL_COLOR, 0, none);
    glClearNamedFramebufferfv(sure_target_.name(), GL_COLOR, 1, nowhere);
    glClearNamedFramebufferfv(sure_target_.name(), GL_DEPTH, 0, &farthest);
    run(sure_, scene, pencil);

    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, doubt_target_.name());
    glClearNamedFramebufferuiv(doubt_target_.name(), GL_COLOR, 0, zero);
    items_.bind(kItemsUnit);
    depths_.bind(kCertifiedDepthsUnit);
    run(doubt_, scene, pencil);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    check("drawing certain items");
}

void CertifiedItems::read_items(std::span<std::uint32_t> items) const
{
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, item_target_.name());
    glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, items.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    check("reading certain items");
}

std::span<const ListedSample> CertifiedItems::read_uncertain()
{
    const auto width = std::size_t(width_);
    marks_.resize(width * std::size_t(height_));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, doubt_target_.name());
    glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_BYTE, marks_.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    check("reading uncertain samples");
    listed_.clear();
    for (auto at = marks_.begin(); (at = std::find(at, marks_.end(), 1)) != marks_.end(); ++at) {
        const auto k = std::size_t(at - marks_.begin());
        listed_.push_back({std::uint16_t(k % width), std::uint16_t(k / width)});
    }
    return listed_;
}

void CertifiedItems::write(
    std::span<const ListedSample> samples, std::span<const std::uint32_t> items)
{
    if (samples.empty()) return;
    given_.clear();
    for (std::size_t k = 0; k < samples.size(); ++k)
        given_.push_back({std::uint32_t(samples[k].y) << 16 | samples[k].x, items[k]});
    given_buffer_.assign(std::span<const GivenItem>(given_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, item_target_.name());
    glViewport(0, 0, width_, height_);
    glDisable(GL_DEPTH_TEST);
    scatter_.use();
    glUniform2f(scatter_.location("size"), GLfloat(width_), GLfloat(height_));
    given_buffer_.bind_storage(kGivenItemsBlock);
    glBindVertexArray(nothing_.name());
    glDrawArrays(GL_POINTS, 0, GLsizei(given_.size()));
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    check("writing items");
}

} // namespace firsthit::gl
