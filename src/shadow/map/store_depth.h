// store_depth.h - the memory layout of a map's texels; copies a rasterised tile into a map.
//
// A map consists of quads of 4x4 texels, row by row, and so do the quads inside, as in a tile
// (base/tile_order.h). A quad is one cache line, so neighbouring hits read few cache lines. The
// last quads of each row and column of quads may extend beyond the map.
#pragma once

#include "shadow/map/raster_depth.h"

#include <cstddef>

namespace firsthit {

inline constexpr int kQuadTexels = 16;

/// The number of quads for a row of so many texels.
constexpr int quads(int texels)
{
    return (texels + 3) / 4;
}

/// Index of texel (x, y) in the memory of a map that is `width` texels wide.
constexpr std::size_t quad_offset(int x, int y, int width)
{
    return (std::size_t(y / 4) * std::size_t(quads(width)) + std::size_t(x / 4)) * kQuadTexels +
           std::size_t(y % 4 * 4 + x % 4);
}

inline constexpr int kCellSide = 16; // texels

/// The farthest depth of each cell of kCellSide x kCellSide texels, (cells down, cells across). The
/// unused texels of quads that extend beyond the map may be counted or not.
struct FarthestDepths {
    int across = 0;
    Buffer<float> depth;

    /// Sets the size to that of a map of width x height texels. Allocates only to grow.
    void resize(int width, int height)
    {
        across = (width + kCellSide - 1) / kCellSide;
        const auto cells = std::size_t(across) * std::size_t((height + kCellSide - 1) / kCellSide);
        depth.resize(cells, cells / 2);
    }
    float& at(int x, int y) { return depth[std::size_t(y * across + x)]; }
    float at(int x, int y) const { return depth[std::size_t(y * across + x)]; }
};

/// Computes the farthest depths of a map whose depths were not stored by store_depth.
/// depth  of all texels, see quad_offset
void find_farthest(const float* depth, int width, int height, FarthestDepths& farthest);

/// A rectangle of a map that starts at a cell and lies inside one tile.
struct MapWindow {
    float* depth;      // of its first texel
    int quads_x;       // of the map
    float* farthest;   // of its first cell
    int cells_x;       // of the map
    int width, height; // texels
};

/// Converts the tile's 1/t to depth (+inf where there is no triangle), and writes it and the
/// farthest depths of the cells into the window.
void store_depth(const DepthTile& tile, const Pencil& pencil, const MapWindow& window);

} // namespace firsthit
