// sample_passes.cpp - the gpu engine's passes over all samples of a section of a picture.
#include "gl/sample_passes.h"

#include "gl/bindings.h"
#include "gl/device/context.h"
#include "material/models.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace firsthit::gl {
namespace {

/// The formats of a plane: of its texture, and of the pixels that the host reads.
struct PlaneFormat {
    std::size_t number; // index of the texture in planes_
    GLenum drawn, read;
};

PlaneFormat plane_format(Aov aov)
{
    if (aov == Aov::item) return {0, GL_R32UI, GL_RED_INTEGER};
    switch (aov == Aov::lit ? 1 : aov_channels(aov)) {
    case 1:
        return {1, GL_R32F, GL_RED};
    case 2:
        return {2, GL_RG32F, GL_RG};
    default:
        return {3, GL_RGBA32F, GL_RGB}; // drivers need not support drawing to three channels
    }
}

struct PixelFormat {
    GLenum channels, type;
};

/// Reads the colours of a framebuffer to rows that may be longer.
void read_rows(
    const Framebuffer& from, glm::ivec2 size, PixelFormat format, void* to, int row_pixels)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, row_pixels);
    glReadPixels(0, 0, size.x, size.y, format.channels, format.type, to);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

} // namespace

SamplePasses::SamplePasses(bool count_invocations) : count_invocations_(count_invocations)
{
    nothing_.create();
    if (count_invocations_) {
        invocations_.resize(4);
        take_invocations();
    }
}

/// Makes room for one more program: deletes the one that was not used for the longest time.
void SamplePasses::make_room()
{
    if (programs_.size() < kMostPrograms) return;
    programs_.erase(std::min_element(programs_.begin(), programs_.end(),
        [](const Linked& a, const Linked& b) { return a.last_use < b.last_use; }));
}

/// The program of a pass in the current variant, linked if there is none yet. Valid until the next
/// call.
const Program& SamplePasses::linked(Pass pass, bool stored, int plane)
{
    static constexpr std::string_view kFiles[] = {"early_z.frag", "intersect.frag",
        "hit_bounds.comp", "shade_hits.frag", "fill_holes.frag", "average.frag",
        "count_samples.comp", "plane.frag"};
    const bool flags[] = {variant_.shadow_maps, variant_.textures, variant_.uv1, variant_.colors,
        variant_.tangents, variant_.few_lights, variant_.environment, stored, count_invocations_};
    unsigned variant = unsigned(pass);
    const auto add = [&](int value, int values) {
        variant = variant * unsigned(values) + unsigned(value);
    };
    add(int(variant_.test), 4);
    add(variant_.item_channels, 5);
    add(plane, kAovCount);
    add(variant_.only_model + 1, kModelCount + 1);
    for (const bool flag : flags) add(flag, 2);
    for (Linked& known : programs_)
        if (known.variant == variant) {
            known.last_use = ++uses_;
            return known.program;
        }

    Defines defines = {{"FIRSTHIT_TEST", std::to_string(int(variant_.test))},
        {"FIRSTHIT_ITEM_CHANNELS", std::to_string(variant_.item_channels)},
        {"FIRSTHIT_SHADOW_MAPS", variant_.shadow_maps ? "1" : "0"},
        {"FIRSTHIT_TEXTURES", variant_.textures ? "1" : "0"},
        {"FIRSTHIT_SECOND_UV", variant_.uv1 ? "1" : "0"},
        {"FIRSTHIT_VERTEX_COLORS", variant_.colors ? "1" : "0"},
        {"FIRSTHIT_TANGENTS", variant_.tangents ? "1" : "0"},
        {"FIRSTHIT_ENVIRONMENT", variant_.environment ? "1" : "0"},
        {"FIRSTHIT_ONLY_MODEL", std::to_string(variant_.only_model)},
        {"FIRSTHIT_FEW_LIGHTS", variant_.few_lights ? std::to_string(kFewLights) : "0"},
        {"FIRSTHIT_COUNT_HITS", stored ? "1" : "0"}, {"FIRSTHIT_PLANE", std::to_string(plane)}};
    if (stored || pass == Pass::count) defines.push_back({"FIRSTHIT_STORED_HITS", ""});
    if (count_invocations_) defines.push_back({"FIRSTHIT_COUNT_INVOCATIONS", ""});
    const std::string_view file = kFiles[std::size_t(pass)];
    make_room();
    programs_.push_back({variant, ++uses_,
        file.ends_with(".comp") ? link_program({file}, defines)
                                : link_program({"screen.vert", file}, defines)});
    return programs_.back().program;
}

void SamplePasses::start(const FrameData& frame, const PassVariant& variant)
{
    frame_data_ = frame;
    variant_ = variant;
    size_ = frame.size;
    frame_.resize(sizeof(FrameData));
    frame_.upload(0, &frame, sizeof(FrameData));
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frame_.name());
    // Drawing the mask and testing against it need the same setting.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
}

void SamplePasses::draw(const Program& program, const Framebuffer& target, glm::ivec2 size)
{
    target.check_complete("shading");
    program.use();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glBindVertexArray(nothing_.name());
    glViewport(0, 0, size.x, size.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SamplePasses::draw_into(
    const Program& program, Texture2D& texture, GLenum format, glm::ivec2 size)
{
    texture.resize(format, size.x, size.y);
    target_.attach(GL_COLOR_ATTACHMENT0, texture.name());
    draw(program, target_, size);
}

void SamplePasses::mask_empty()
{
    mask_.resize(GL_DEPTH_COMPONENT32F, size_.x, size_.y);
    target_.attach(GL_COLOR_ATTACHMENT0, 0);
    target_.attach(GL_DEPTH_ATTACHMENT, mask_.name());
    const float far = 1;
    glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &far);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    draw(linked(Pass::early_z), target_, size_);
    glDisable(GL_DEPTH_TEST);
    target_.attach(GL_DEPTH_ATTACHMENT, 0);
}

namespace {

/// While it exists, only samples that are in the mask are drawn.
class Masked {
  public:
    Masked(const Texture2D& mask, Framebuffer& target, bool masked)
        : target_(target),
          masked_(masked)
    {
        if (!masked_) return;
        target_.attach(GL_DEPTH_ATTACHMENT, mask.name());
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
    }
    ~Masked()
    {
        if (!masked_) return;
        glDepthMask(GL_TRUE);
        glDisable(GL_DEPTH_TEST);
        target_.attach(GL_DEPTH_ATTACHMENT, 0);
    }
    Masked(const Masked&) = delete;
    Masked& operator=(const Masked&) = delete;

  private:
    Framebuffer& target_;
    bool masked_;
};

} // namespace

void SamplePasses::find_hits(bool masked)
{
    if (count_invocations_) invocations_.bind_storage(kResultBlock);
    const Program& program = linked(Pass::intersect);
    hits_.resize(GL_RGBA32UI, size_.x, size_.y);
    target_.attach(GL_COLOR_ATTACHMENT0, hits_.name());
    if (masked) {
        const GLuint nothing[4] = {0xFFFFFFFFu, 0, 0, 0};
        glClearNamedFramebufferuiv(target_.name(), GL_COLOR, 0, nothing);
    }
    const Masked mask(mask_, target_, masked);
    draw(program, target_, size_);
    hits_.bind(kHitsUnit);
}

void SamplePasses::find_bounds(bool stored, std::span<LightBounds> bounds)
{
    hit_bounds_.find(linked(Pass::bounds, stored), size_, bounds);
}

void SamplePasses::shade(const PassInput& input)
{
    if (count_invocations_) invocations_.bind_storage(kResultBlock);
    const Program& program = linked(Pass::shade, input.stored);
    colors_.resize(GL_RGBA32F, size_.x, size_.y);
    target_.attach(GL_COLOR_ATTACHMENT0, colors_.name());
    if (input.masked) {
        const glm::vec3& b = frame_data_.background;
        const float background[4] = {b.x, b.y, b.z, kBackgroundAlpha};
        glClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, background);
    }
    const Masked mask(mask_, target_, input.masked);
    draw(program, target_, size_);
    newest_ = &colors_;
}

void SamplePasses::fill_holes()
{
    newest_->bind(kColorsUnit);
    draw_into(linked(Pass::fill), filled_, GL_RGBA32F, size_);
    newest_ = &filled_;
}

void SamplePasses::average(int samples)
{
    const Program& program = linked(Pass::average);
    program.use();
    glUniform1i(kAverageSamples, samples);
    newest_->bind(kColorsUnit);
    size_ /= samples;
    draw_into(program, pixels_, GL_RGBA32F, size_);
    newest_ = &pixels_;
}

SampleCounts SamplePasses::count(bool hits)
{
    const glm::ivec2 size = hits ? frame_data_.size : size_;
    SampleCounts counts;
    counts_.resize(sizeof counts);
    counts_.upload(0, &counts, sizeof counts);
    counts_.bind_storage(kResultBlock);
    if (!hits) newest_->bind(kColorsUnit);
    linked(Pass::count, hits).use();
    const GLuint blocks = (GLuint(size.x + 7) / 8) * (GLuint(size.y + 7) / 8);
    glDispatchCompute((blocks + 31) / 32, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(counts_.name(), 0, sizeof counts, &counts);
    return counts;
}

void SamplePasses::read_colors(float* to, int row_pixels)
{
    target_.attach(GL_COLOR_ATTACHMENT0, newest_->name());
    read_rows(target_, size_, {GL_RGB, GL_FLOAT}, to, row_pixels);
    check("reading a picture");
}

void SamplePasses::read_plane(Aov aov, bool stored, std::size_t light, void* to, int row_pixels)
{
    const Program& program = linked(Pass::plane, stored, int(aov));
    if (aov == Aov::lit) {
        program.use();
        glUniform1i(kPlaneLight, GLint(light));
    }
    const PlaneFormat format = plane_format(aov);
    draw_into(program, planes_[format.number], format.drawn, frame_data_.size);
    const GLenum type = aov == Aov::item ? GL_UNSIGNED_INT : GL_FLOAT;
    read_rows(target_, frame_data_.size, {format.read, type}, to, row_pixels);
    check("reading a plane");
}

std::uint64_t SamplePasses::take_invocations()
{
    if (!count_invocations_) return 0;
    GLuint count = 0;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(invocations_.name(), 0, 4, &count);
    const GLuint zero = 0;
    invocations_.upload(0, &zero, 4);
    return count;
}

} // namespace firsthit::gl
