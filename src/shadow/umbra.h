// umbra.h - tiles that a wall hides from a light as a whole: behind a wall, under a roof.
//
// Their hits need no shadow rays, nor does anything have to be made for them. A wall is a triangle, or
// two neighbours with a common edge. Only triangles of parts that have few are tried, as walls and roofs
// do: no pass over a mesh.
//
// source  Hudson et al. 1997, "Accelerated Occlusion Culling using Shadow Frusta" (what a large polygon
//         hides from the eye)
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/shadow_ray.h"
#include "irregular/samples.h"
#include "shadow/tile_hull.h"

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
struct Umbra {
    Buffer<std::uint32_t> walls;  // triangles of parts that have few
    double farthest = 0;          // largest coordinate of all vertices, world space
    Buffer<TileHull> hulls;       // (tiles)
    Buffer<TileSight> sights;     // (tiles) of one light
    Buffer<std::uint8_t> hidden;  // (tiles) of one light: all hits certainly lie in the shadow
    Buffer<float> range_farthest; // (ranges) of vertices

    /// Whether there is something to try.
    bool has_walls() const { return walls.size() > 0; }
};

/// Begins a part of the picture. Costs next to nothing in a scene without small parts.
void start_umbra(const World& world, std::size_t tiles, Umbra& umbra, Tasks& tasks);

/// Takes note of where a tile's hits are. For all tiles if umbra.has_walls(); calls for several tiles
/// may overlap.
void add_hits(const HitTile& hits, std::size_t tile, Umbra& umbra);

/// Fills in umbra.hidden for one light; tiles without hits are hidden. One that is not said to be
/// hidden may be so nevertheless. Needs walls.
/// space   of the light
/// tiles   all that were added
/// returns whether all tiles are hidden
bool find_umbra(const World& world, const LightSpace& space, std::span<const HitTile> tiles,
    Umbra& umbra, Tasks& tasks);

} // namespace firsthit
