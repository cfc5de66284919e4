// store_depth.h - how the texels of a map are laid out, and from a rasterised tile to the map.
//
// A map is made of quads of 4x4 texels, row by row, as the quads of a tile are (base/tile_order.h):
// a quad is one cache line, and neighbouring hits look at few of them. The last quads of a row and
// of a column may be filled in part.
#pragma once

#include "shadow/map/raster_depth.h"

#include <cstddef>

namespace firsthit {

inline constexpr int kQuadTexels = 16;

/// Quads that hold so many texels in a row.
constexpr int quads(int texels)
{
    return (texels + 3) / 4;
}

/// Where texel (x, y) of a map that is `width` texels wide is in memory.
constexpr std::size_t quad_offset(int x, int y, int width)
{
    return (std::size_t(y / 4) * std::size_t(quads(width)) + std::size_t(x / 4)) * kQuadTexels +
           std::size_t(y % 4 * 4 + x % 4);
}

inline constexpr int kCellSide = 16; // texels

/// (cells down, cells across) the farthest depth of each. Texels beyond the map's edge may count.
struct FarthestDepths {
    int across = 0;
    Buffer<float> depth;

    /// Of a map of that many texels. Allocates where it is larger than before.
    void resize(int width, int height)
    {
        across = (width + kCellSide - 1) / kCellSide;
        const auto cells = std::size_t(across) * std::size_t((height + kCellSide - 1) / kCellSide);
        depth.resize(cells, cells / 2);
    }
    float& at(int x, int y) { return depth[std::size_t(y * across + x)]; }
    float at(int x, int y) const { return depth[std::size_t(y * across + x)]; }
};

/// Finds them where the depths came from elsewhere. depth: a map's, see quad_offset
void find_farthest(const float* depth, int width, int height, FarthestDepths& farthest);

/// A rectangle of a map that starts at a cell and lies inside one tile.
struct MapWindow {
    float* depth;      // of its first texel
    int quads_x;       // of the map
    float* farthest;   // of its first cell
    int cells_x;       // of the map
    int width, height; // texels
};

/// Turns the tile's 1/t into depth (+inf where nothing is) and writes it, and the cells' farthest.
void store_depth(const DepthTile& tile, const Pencil& pencil, const MapWindow& window);

} // namespace firsthit
