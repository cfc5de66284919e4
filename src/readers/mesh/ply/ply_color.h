// ply_color.h - colours of a PLY file as linear light.
#pragma once

#include "readers/mesh/ply/ply_header.h"

#include <glm/vec4.hpp>

#include <span>

namespace firsthit {

/// Turns colours as the file has them, sRGB, into linear light, in place. Values are shares of 1 in
/// float and double, of 65535 in ushort, and of 255 in all other types; those outside are clamped.
/// Alpha is a share as it is, 1 where the element has none. Values that are not finite become 1.
///
/// element  whose properties they were
/// returns  how many colours were not finite
std::size_t make_linear(std::span<glm::vec4> colors, const PlyElement& element);

} // namespace firsthit
