// program.h - shaders from the library's texts.
#pragma once

#include "gl/device/objects.h"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::gl {

/// A `#define name value` before a shader's text.
struct Define {
    std::string name;
    std::string value;
};
using Defines = std::vector<Define>;

/// A shader as the driver gets it.
struct ShaderSource {
    GLenum type = 0;                     // GL_VERTEX_SHADER, ...: by the name's ending
    std::string text;                    // from #version on
    std::vector<std::string_view> files; // number k of a log is the line of this file
};

/// The text of src/gl/shaders, src/glsl or src/material with that name: "pose.comp" or
/// "gl/shaders/pose.comp"; or "models.glsl", which glsl_models writes.
/// Each `#include "name"` is replaced by its text where it comes first, later ones by nothing. In
/// front stand the version, the words of src/glsl (real, real3, ...) and the defines.
///
/// name    ends in .vert .frag .geom .comp
/// throws  ArgumentError: no such text, no such ending
ShaderSource shader_source(std::string_view name, std::span<const Define> defines = {});

/// Compiles and links shaders, all with the same defines.
/// throws  DeviceError: the driver refuses one; has the shader's name, the driver and its log
Program link_program(
    std::initializer_list<std::string_view> names, std::span<const Define> defines = {});

/// Compiles and links one shader that is not among the library's texts.
Program link_source(const ShaderSource& source);

} // namespace firsthit::gl
