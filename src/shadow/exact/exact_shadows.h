// exact_shadows.h - which lights reach what the eye sees: for every hit and light the answer of a
// shadow ray.
#pragma once

#include "base/tasks.h"
#include "hits/hit_tile.h"
#include "hits/light_visibility.h"
#include "irregular/grid/grid_shadows.h"
#include "irregular/mesh/project_points_to_face.h"
#include "irregular/zbuffer.h"
#include "shadow/exact/find_receivers.h"
#include "shadow/exact/tile_occlusion.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firsthit {

/// Where the time went, in milliseconds, and what it took.
struct ShadowEffort {
    double collect_ms = 0;    // hits to points in the light's space
    double see_ms = 0;        // vertices and triangles to the light's faces
    double sort_ms = 0;       // into the cells
    double test_ms = 0;       // triangles over points
    std::uint64_t points = 0; // that a light might reach
    TestCounts counts;
};

/// What one worker collects.
struct ShadowWorker {
    TileReceivers receivers;
    PointChunk chunk;
};

/// Which way triangles meet the samples of a face.
enum class ShadowPlan {
    automatic, // by the numbers of both
    grid,      // small triangles by the grid (grid_shadows.h), the others as below
    cells,     // all sorted into patches and cells (irregular/zbuffer.h)
};

/// Kept from frame to frame.
struct ShadowMemory {
    ShadowPlan plan = ShadowPlan::automatic;
    PencilMesh mesh;
    IrregularMemory irregular;
    SampleGrid grid;
    std::vector<GridTestCounts> grid_counts;       // (threads)
    Buffer<IrregularSample, Pages::small> samples; // (chunks, chunk_room)
    std::vector<FacePatches> parts;                // (chunks)
    Buffer<SamplePatch> patches;                   // (chunks) of one face
    Buffer<std::uint8_t> shadowed;                 // (points) of one light
    std::vector<std::unique_ptr<ShadowWorker>> workers;
    ShadowEffort effort; // so far; take_effort moves it away
};

/// What was done since the last call.
ShadowEffort take_effort(ShadowMemory& memory);

/// Room for what the workers need.
void resize(ShadowMemory& memory, std::size_t chunks, std::size_t points_a_chunk, int threads);

/// Tests the samples of all chunks: shadowed[id] = 1 for those that a triangle shadows. A chunk is
/// the points that were collected together: those of a tile, or some that are no pixels. memory.mesh,
/// samples and parts are filled in.
void test_chunks(const PencilPoints& points, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed);

/// A bit for each sample of each tile and light: does the light reach it? In tile order; word k of
/// a tile's light belongs to its block k.
struct LitBits {
    Buffer<std::uint64_t> words; // (lights, tiles, blocks)
    std::size_t lights = 0;
    std::size_t tiles = 0;
    std::size_t blocks = 0; // of a tile

    std::size_t place(std::size_t light, std::size_t tile) const
    {
        return (light * tiles + tile) * blocks;
    }
};

/// A tile's part of all lights as floats, in `memory`.
LightVisibility unpack_lit(const LitBits& bits, std::size_t tile, Buffer<float>& memory);

/// Fills in `lit` for all tiles' hits and all lights of the world. A hit is lit where the light is
/// on the side of the item's plane that the eye is on, the hit is inside a spot's cone, and no other
/// triangle shadows it (exact/shadow_ray.h).
/// eye    where the hits were seen from
/// tiles  of one picture part, all of one size, whose items lie one behind the other
/// tile_occlusion  of these tiles, if it has occluders: tiles that it hides need no tests; or null
void test_exact_shadows(const World& world, const glm::dvec3& eye, std::span<const HitTile> tiles,
    ShadowMemory& memory, Tasks& tasks, LitBits& lit, TileOcclusion* tile_occlusion = nullptr);

} // namespace firsthit
