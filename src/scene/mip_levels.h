// mip_levels.h - the smaller copies of a texture.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Replaces all levels but the first, which must not be empty, by averages down to 1 x 1. Each
/// level is half the one before, rounded down, at least 1; texels that straddle two smaller ones
/// count for both by their share. Colours are averaged in linear light, alpha as it is.
void make_mip_levels(Texture& texture);

} // namespace firsthit
