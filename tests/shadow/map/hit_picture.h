// hit_picture.h - the hits of a whole picture, tile by tile, as a frame finds them.
#pragma once

#include "hits/resolve_tile.h"
#include "render/check_settings.h"
#include "visibility/bin/bins.h"
#include "visibility/bin/project.h"
#include "visibility/raster/raster_tile.h"

#include <firsthit/scene.h>

#include <memory>
#include <vector>

namespace firsthit::test {

/// Keeps the hits of all tiles at once. For small pictures and for measurements.
struct HitPicture {
    struct Tile {
        ItemTile items{};
        HitMemory memory;
        HitTile hits;
    };
    ViewMemory view;
    std::vector<std::unique_ptr<Tile>> tiles;

    HitPicture(const World& world, const View& wanted, Tasks& tasks, int tile_size = 64)
    {
        const View filled = checked(wanted);
        view.pencil = pencil_of(filled, filled.region, 1);
        view.tile_size = tile_size;
        view.tiles_x = (view.pencil.width + tile_size - 1) / tile_size;
        view.tiles_y = (view.pencil.height + tile_size - 1) / tile_size;
        const int longest = std::max(view.pencil.width, view.pencil.height);
        view.tile_of.resize(std::size_t(longest));
        for (int k = 0; k < longest; ++k)
            view.tile_of[std::size_t(k)] = std::uint8_t(k / tile_size);
        project_vertices(world.position, view, tasks);
        bin_triangles(world.scene->index, view, tasks);
        for (int k = 0; k < view.tiles(); ++k) {
            tiles.push_back(std::make_unique<Tile>());
            Tile& tile = *tiles.back();
            resize(tile.items, tile_size);
            resize(tile.memory, tile_size, 1);
            raster_tile(view, k, tile.items);
            tile.hits = resolve_tile(view, tile.items, tile.memory.of(0));
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
