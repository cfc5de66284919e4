// program.h - compiles and links shaders from the texts that are embedded in the library.
#pragma once

#include "gl/device/objects.h"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::gl {

/// A `#define name value` that is inserted before the text of a shader.
struct Define {
    std::string name;
    std::string value;
};
using Defines = std::vector<Define>;

/// A shader as it is handed to the driver.
struct ShaderSource {
    GLenum type = 0;                     // GL_VERTEX_SHADER, ...; follows from the name's ending
    std::string text;                    // the whole text, from #version on
    std::vector<std::string_view> files; // files[k] is the file that a log calls k
};

/// Puts together the text of a shader: the version, the types of src/glsl (real, real3, ...), the
/// defines, and the text of src/gl, src/glsl or src/material with that name ("pose.comp" or
/// "gl/shaders/pose.comp"). An `#include "name"` is replaced by that text, but only the first time;
/// later ones are dropped. "models.glsl" is the text that glsl_models() writes.
///
/// name    ends in .vert .frag .geom .comp
/// throws  ArgumentError: no such text, no such ending
ShaderSource shader_source(std::string_view name, std::span<const Define> defines = {});

/// Compiles and links shaders, all with the same defines.
/// throws  DeviceError: the driver refuses one; the message has the shader's name, the driver and
///         its log
Program link_program(
    std::initializer_list<std::string_view> names, std::span<const Define> defines = {});

/// Compiles and links one shader that is not among the library's texts.
Program link_source(const ShaderSource& source);

} // namespace firsthit::gl
