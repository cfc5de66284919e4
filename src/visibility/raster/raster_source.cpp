// raster_source.cpp - the ItemSource of the software rasteriser.
#include "visibility/raster/raster_source.h"

#include "visibility/bin/bin_triangles.h"
#include "visibility/bin/project.h"
#include "visibility/raster/raster_tile.h"

#include <algorithm>

namespace firsthit {
namespace {

/// Clears the items of samples outside the picture. The rasteriser sets them, since it works on
/// whole registers.
void clear_outside(const TileLayout& layout, int tile, TileItems& out)
{
    const int columns = layout.pencil.width - layout.first_x(tile);
    const int rows = layout.pencil.height - layout.first_y(tile);
    if (columns >= out.size && rows >= out.size) return;
    for (int y = 0; y < out.size; ++y)
        for (int x = y < rows ? std::min(columns, out.size) : 0; x < out.size; ++x)
            out.item[std::size_t(tile_offset(x, y, out.size))] = kNoItem;
}

} // namespace

bool RasterSource::start(const World& world, ViewMemory& memory, Tasks& tasks)
{
    while (int(scratch_.size()) < tasks.threads())
        scratch_.push_back(std::make_unique<RasterScratch>());
    for (const auto& scratch : scratch_) resize(*scratch, memory.tile_size);
    take_triangles(*world.scene, memory);
    project_vertices(world.position, memory.pencil, memory, tasks);
    return bin_triangles(memory, memory, memory, tasks);
}

std::size_t RasterSource::wait(const ViewMemory& memory)
{
    return std::size_t(memory.tiles());
}

void RasterSource::tile(const ViewMemory& memory, int tile, TileItems& out,
    std::span<std::uint64_t> /*holes*/, std::size_t worker)
{
    raster_tile(
        memory, memory.rays(tile), bin_of(memory, std::size_t(tile)), out, *scratch_[worker]);
    clear_outside(memory, tile, out);
}

} // namespace firsthit
