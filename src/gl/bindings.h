// bindings.h - the numbers of the blocks and texture units that the gpu engine's shaders share.
// Their texts have the same numbers.
#pragma once

#include <epoxy/gl.h>

namespace firsthit::gl {

/// The uniform block of frame.glsl.
inline constexpr GLuint kFrame = 0;

/// Storage blocks; lights and maps are uniform blocks where they are few.
inline constexpr GLuint kResult = 0; // what a pass writes
inline constexpr GLuint kLights = 1;
inline constexpr GLuint kMaps = 2;

/// Texture units: pictures.
inline constexpr GLuint kItemsUnit = 0;
inline constexpr GLuint kHitsUnit = 2;
inline constexpr GLuint kColorsUnit = 3;
inline constexpr GLuint kDepthUnit = 4;

/// Texture units: arrays.
inline constexpr GLuint kIndexUnit = 5;
inline constexpr GLuint kEyeUnit = 6;
inline constexpr GLuint kWorldUnit = 7;
inline constexpr GLuint kNormalUnit = 8;
inline constexpr GLuint kUvUnit = 9;
inline constexpr GLuint kTriangleMaterialUnit = 10;
inline constexpr GLuint kMaterialsUnit = 11;
inline constexpr GLuint kTexturesUnit = 12;
inline constexpr GLuint kMapDepthUnit = 13;

} // namespace firsthit::gl
