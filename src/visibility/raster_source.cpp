// raster_source.cpp - items by our own rasteriser, tile by tile.
#include "visibility/raster_source.h"

#include "visibility/bins.h"
#include "visibility/project.h"
#include "visibility/raster_tile.h"

namespace firsthit {

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
}

} // namespace firsthit
