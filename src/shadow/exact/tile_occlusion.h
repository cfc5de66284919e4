// tile_occlusion.h - occluder culling: finds tiles that one large occluder hides from a light.
//
// All hits of such a tile are in shadow, so they need no shadow rays and no shadow map. An occluder
// is one triangle, or two triangles with a common edge. Only triangles of scene parts with few
// triangles are tried, since walls and roofs are modelled that way; meshes are not searched.
//
// source  Hudson et al. 1997, "Accelerated Occlusion Culling using Shadow Frusta" (what a large
//         polygon hides from the eye)
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/cutouts.h"
#include "exact/shadow_ray.h"
#include "irregular/mesh/samples.h"
#include "shadow/exact/tile_hull.h"

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// The bounds of a tile's hits on a face of a light; face -1: no single face sees all of them.
struct TileBounds {
    int face = -1;
    SampleBounds bounds;
};

/// Memory that is kept from frame to frame.
struct TileOcclusion {
    Cutouts cutouts;                 // which hide nothing
    Buffer<std::uint32_t> occluders; // triangles of scene parts with few triangles
    double farthest = 0;             // largest absolute coordinate of all vertices, world space
    Buffer<TileHull> hulls;          // (tiles)
    Buffer<TileBounds> bounds;       // (tiles) for the current light
    Buffer<std::uint8_t> hidden;     // (tiles) for the current light: 1 if all hits are in shadow
    Buffer<float> range_farthest;    // (ranges of vertices) scratch memory of `farthest`

    /// Whether there are occluders to try.
    bool has_occluders() const { return occluders.size() > 0; }
};

/// Begins a section of the picture: finds the occluders. Costs next to nothing in a scene without
/// any.
void start_tile_occlusion(
    const World& world, std::size_t tiles, TileOcclusion& tile_occlusion, Tasks& tasks);

/// Records where a tile's hits are. To be called for every tile if tile_occlusion.has_occluders().
/// Calls for different tiles may run at the same time.
void add_hits(const HitTile& hits, std::size_t tile, TileOcclusion& tile_occlusion);

/// Fills in tile_occlusion.hidden for one light. Tiles without hits count as hidden. Conservative:
/// a tile that is not marked as hidden may be in shadow nevertheless. Requires occluders.
/// space   of the light
/// tiles   those given to add_hits, in the same order
/// returns whether all tiles are hidden
bool find_occluded_tiles(const World& world, const PencilSpace& space,
    std::span<const HitTile> tiles, TileOcclusion& tile_occlusion, Tasks& tasks);

} // namespace firsthit
