// tile_texture.h - a tiled floor, made in code.
#pragma once

#include <firsthit/texture.h>

namespace firsthit {

/// 8 x 8 stone tiles with grout between them, 512 x 512 texels with all levels; it repeats without
/// a seam. The same bits every time.
Texture make_tiles();

} // namespace firsthit
