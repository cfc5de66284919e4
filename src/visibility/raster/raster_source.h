// raster_source.h - the ItemSource of the software rasteriser.
#pragma once

#include "visibility/item_source.h"

namespace firsthit {

class RasterSource final : public ItemSource {
  public:
    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override;
    std::size_t wait(const ViewMemory& memory) override;
    void tile(const ViewMemory& memory, int tile, ItemTile& out, std::span<std::uint64_t> holes,
        std::size_t worker) override;
};

} // namespace firsthit
