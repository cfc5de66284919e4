// raster_source.cpp - the ItemSource of the software rasteriser.
#include "visibility/raster/raster_source.h"

#include "visibility/bin/bins.h"
#include "visibility/bin/project.h"
#include "visibility/raster/raster_tile.h"

#include <algorithm>

namespace firsthit {
namespace {

/// Clears the items of samples outside the picture, which the rasteriser fills in because it works
/// on whole registers.
void clear_outside(const ViewMemory& memory, int tile, ItemTile& out)
{
    const int columns = memory.pencil.width - tile % memory.tiles_x * out.size;
    const int rows = memory.pencil.height - tile / memory.tiles_x * out.size;
    if (columns >= out.size && rows >= out.size) return;
    for (int y = 0; y < out.size; ++y)
        for (int x = y < rows ? std::min(columns, out.size) : 0; x < out.size; ++x)
            out.item[std::size_t(out.column_offset[x] + out.row_offset[y])] = kNoItem;
}

} // namespace

bool RasterSource::start(const World& world, ViewMemory& memory, Tasks& tasks)
{
    project_vertices(world.position, memory, tasks);
    return bin_triangles(world.scene->index, memory, tasks);
}

std::size_t RasterSource::wait(const ViewMemory& memory)
{
    return std::size_t(memory.tiles());
}

void RasterSource::tile(const ViewMemory& memory, int tile, ItemTile& out,
    std::span<std::uint64_t> /*holes*/, std::size_t /*worker*/)
{
    raster_tile(memory, tile, out);
    clear_outside(memory, tile, out);
}

} // namespace firsthit
