// picture_quad.cpp - shows pixels on all of the window.
#include "view/window/picture_quad.h"

#include <firsthit/error.h>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

namespace firsthit::cli::view {
namespace {

constexpr const char* kVertex = R"(#version 330 core
out vec2 uv;
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    uv = vec2(corner.x * 0.5 + 0.5, 0.5 - corner.y * 0.5);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr const char* kFragment = R"(#version 330 core
in vec2 uv;
out vec4 color;
uniform sampler2D picture;
void main() { color = texture(picture, uv); }
)";

void compile(GLuint program, GLenum kind, const char* text)
{
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        std::array<char, 512> log{};
        glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
        throw DeviceError(fmt::format("the window's shader does not compile: {}", log.data()));
    }
    glAttachShader(program, shader);
    glDeleteShader(shader);
}

} // namespace

PictureQuad::PictureQuad()
{
    program_ = glCreateProgram();
    compile(program_, GL_VERTEX_SHADER, kVertex);
    compile(program_, GL_FRAGMENT_SHADER, kFragment);
    glLinkProgram(program_);
    glGenVertexArrays(1, &vertices_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

PictureQuad::~PictureQuad()
{
    glDeleteTextures(1, &texture_);
    glDeleteVertexArrays(1, &vertices_);
    glDeleteProgram(program_);
}

void PictureQuad::upload(const std::vector<std::uint8_t>& rgba, int width, int height)
{
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (width != width_ || height != height_)
        glTexImage2D(
            GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    else
        glTexSubImage2D(
            GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    width_ = width;
    height_ = height;
}

void PictureQuad::draw(int framebuffer_width, int framebuffer_height)
{
    glViewport(0, 0, framebuffer_width, framebuffer_height);
    if (width_ == 0) {
        glClearColor(0.11f, 0.11f, 0.13f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    const bool same = width_ == framebuffer_width && height_ == framebuffer_height;
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(program_);
    glBindVertexArray(vertices_);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, same ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, same ? GL_NEAREST : GL_LINEAR);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
}

} // namespace firsthit::cli::view
