// store_depth.h - from a rasterised tile to the map.
#pragma once

#include "shadow/raster_depth.h"

namespace firsthit {

/// A rectangle of a map that lies inside one tile.
struct MapWindow {
    float* depth; // of its first texel
    int stride;   // texels from row to row
    int width, height;
};

/// Turns the tile's 1/t into depth (+inf where nothing is) and writes it. The tile's content is
/// lost.
void store_depth(DepthTile& tile, const Pencil& pencil, const MapWindow& window);

} // namespace firsthit
