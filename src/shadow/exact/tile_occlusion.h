// tile_occlusion.h - tiles that a wall hides from a light as a whole: behind a wall, under a roof.
//
// Their hits need no shadow rays, nor does anything have to be made for them. A wall is a triangle, or
// two neighbours with a common edge. Only triangles of parts that have few are tried, as occluders and roofs
// do: no pass over a mesh.
//
// source  Hudson et al. 1997, "Accelerated Occlusion Culling using Shadow Frusta" (what a large polygon
//         hides from the eye)
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/shadow_ray.h"
#include "irregular/mesh/samples.h"
#include "shadow/exact/tile_hull.h"

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// A tile's hits as a face of a light sees them; -1: no single face does.
struct TileSight {
    int face = -1;
    SampleBounds bounds;
};

/// Kept from frame to frame.
struct TileOcclusion {
    Buffer<std::uint32_t> occluders; // triangles of parts that have few
    double farthest = 0;             // largest coordinate of all vertices, world space
    Buffer<TileHull> hulls;          // (tiles)
    Buffer<TileSight> sights;        // (tiles) of one light
    Buffer<std::uint8_t> hidden;     // (tiles) of one light: all hits certainly lie in the shadow
    Buffer<float> range_farthest;    // (ranges) of vertices

    /// Whether there is something to try.
    bool has_occluders() const { return occluders.size() > 0; }
};

/// Begins a part of the picture. Costs next to nothing in a scene without small parts.
void start_tile_occlusion(
    const World& world, std::size_t tiles, TileOcclusion& tile_occlusion, Tasks& tasks);

/// Takes note of where a tile's hits are. For all tiles if tile_occlusion.has_occluders(); calls for several tiles
/// may overlap.
void add_hits(const HitTile& hits, std::size_t tile, TileOcclusion& tile_occlusion);

/// Fills in tile_occlusion.hidden for one light; tiles without hits are hidden. One that is not said to be
/// hidden may be so nevertheless. Needs occluders.
/// space   of the light
/// tiles   all that were added
/// returns whether all tiles are hidden
bool find_occluded_tiles(const World& world, const PencilSpace& space,
    std::span<const HitTile> tiles, TileOcclusion& tile_occlusion, Tasks& tasks);

} // namespace firsthit
