// raster_source.h - the ItemSource of the software rasteriser.
#pragma once

#include "visibility/item_source.h"
#include "visibility/raster/raster_scratch.h"

#include <memory>
#include <vector>

namespace firsthit {

/// Projects and bins the triangles in start(), and rasterises them in tile(). It never has holes.
class RasterSource final : public ItemSource {
  public:
    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override;
    std::size_t wait(const ViewMemory& memory) override;
    void tile(const ViewMemory& memory, int tile, TileItems& out, std::span<std::uint64_t> holes,
        std::size_t worker) override;

  private:
    std::vector<std::unique_ptr<RasterScratch>> scratch_; // of each worker
};

} // namespace firsthit
