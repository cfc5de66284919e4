// raster_source.cpp - items by our own rasteriser, tile by tile.
#include "visibility/raster_source.h"

#include "visibility/bins.h"
#include "visibility/project.h"
#include "visibility/raster_tile.h"

#include <firsthit/scene.h>

namespace firsthit {
namespace {

/// The rasteriser fills whole blocks: what lies beyond the picture is nobody's hit.
void clear_outside(const ViewMemory& memory, int tile, ItemTile& out)
{
    const int columns = memory.pencil.width - tile % memory.tiles_x * out.size;
    const int rows = memory.pencil.height - tile / memory.tiles_x * out.size;
    if (columns >= out.size && rows >= out.size) return;
    for (int y = 0; y < out.size; ++y)
        for (int x = y < rows ? columns : 0; x < out.size; ++x)
            out.item[std::size_t(tile_offset(x, y, out.size))] = kNoItem;
}

} // namespace

bool RasterSource::start(const World& world, const View& /*view*/, const Region& /*part*/,
    int /*samples*/, ViewMemory& memory, Tasks& tasks)
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
