// shader_texts.h - the texts of all shaders, which the build embeds in the library.
#pragma once

#include <span>
#include <string_view>

namespace firsthit::gl {

struct ShaderText {
    std::string_view name; // from src/: "gl/shaders/pose.comp"
    std::string_view text;
};

/// All of them, in the order of src/gl/CMakeLists.txt.
std::span<const ShaderText> shader_texts();

} // namespace firsthit::gl
