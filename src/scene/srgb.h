// srgb.h - between 8-bit sRGB and linear light.
//
// source  IEC 61966-2-1
#pragma once

#include <array>
#include <cstdint>

namespace firsthit {

/// Linear light, 0 to 1, of each 8-bit sRGB value.
const std::array<float, 256>& linear_from_srgb8();

/// The 8-bit sRGB value nearest in sRGB; clamps.
std::uint8_t srgb8_from_linear(float linear);

} // namespace firsthit
