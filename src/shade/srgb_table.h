// srgb_table.h - linear light of 8-bit sRGB.
#pragma once

namespace firsthit {

/// 256 floats in [0, 1].
///
/// source  IEC 61966-2-1:1999
const float* linear_of_srgb();

} // namespace firsthit
