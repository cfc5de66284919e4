// bindings.h - bindings.glsl as C++: the numbers of blocks, texture units and uniforms of shaders.
#pragma once

namespace firsthit::gl {

#define FIRSTHIT_CONSTANT(type, name, value) inline constexpr type name = value;
#include "gl/bindings.glsl"
#undef FIRSTHIT_CONSTANT

} // namespace firsthit::gl
