// hit_picture.h - the hits of a whole picture, tile by tile, as a frame finds them.
#pragma once

#include "hits/resolve_tile.h"
#include "render/check_settings.h"
#include "visibility/bin/bin_triangles.h"
#include "visibility/bin/project.h"
#include "visibility/bin/view_memory.h"
#include "visibility/raster/raster_tile.h"

#include <firsthit/scene.h>

#include <memory>
#include <vector>

namespace firsthit::test {

/// Keeps the hits of all tiles at once. For small pictures and for measurements.
struct HitPicture {
    struct Tile {
        TileItems items;
        HitMemory memory;
        HitTile hits;
    };
    ViewMemory view;
    std::vector<std::unique_ptr<Tile>> tiles;

    HitPicture(const World& world, const View& wanted, Tasks& tasks, int tile_size = 64)
    {
        const View filled = checked(wanted);
        lay_out(pencil_of(filled, filled.region, 1), tile_size, view);
        take_triangles(*world.scene, view);
        project_vertices(world.position, view.pencil, view, tasks);
        bin_triangles(view, view, view, tasks);
        const auto scratch = std::make_unique<RasterScratch>();
        resize(*scratch, tile_size);
        for (int k = 0; k < view.tiles(); ++k) {
            tiles.push_back(std::make_unique<Tile>());
            Tile& tile = *tiles.back();
            resize(tile.items, tile_size);
            resize(tile.memory, tile_size, 1);
            raster_tile(view, view.rays(k), bin_of(view, std::size_t(k)), tile.items, *scratch);
            tile.hits = resolve_tile(view, view.pencil, tile.items, tile.memory.of(0));
        }
    }

    /// Calls body(tile's number, its hits, x, y, offset in the tile) for each sample with an item.
    template <class Body>
    void for_hits(const Body& body) const
    {
        for (std::size_t k = 0; k < tiles.size(); ++k) {
            const HitTile& hits = tiles[k]->hits;
            for (int y = 0; y < hits.size; ++y)
                for (int x = 0; x < hits.size; ++x) {
                    const int offset = tile_offset(x, y, hits.size);
                    if (hits.item[offset] != kNoItem) body(k, hits, x, y, offset);
                }
        }
    }
};

} // namespace firsthit::test
