// bindings.h - the numbers of the storage blocks and texture units that the gpu engine's shaders
// share. Their texts have the same numbers.
#pragma once

#include <epoxy/gl.h>

namespace firsthit::gl {

/// Storage blocks.
inline constexpr GLuint kIndex = 0;
inline constexpr GLuint kEye = 1;
inline constexpr GLuint kWorld = 2;
inline constexpr GLuint kNormal = 3;
inline constexpr GLuint kTriangleMaterial = 4;
inline constexpr GLuint kMaterials = 5;
inline constexpr GLuint kTextureWords = 6;
inline constexpr GLuint kResult = 7; // what a pass writes
inline constexpr GLuint kLights = 8;
inline constexpr GLuint kMaps = 9;
inline constexpr GLuint kMapDepth = 10;
inline constexpr GLuint kUv = 11;
inline constexpr int kStorageBlocks = 12;

/// The uniform block of frame.glsl.
inline constexpr GLuint kFrame = 0;

/// Texture units.
inline constexpr GLuint kItemsUnit = 0;
inline constexpr GLuint kHitsUnit = 1;
inline constexpr GLuint kColorsUnit = 2;
inline constexpr GLuint kItemColorsUnit = 3;
inline constexpr GLuint kDepthUnit = 4;

} // namespace firsthit::gl
