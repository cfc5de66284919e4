// exact_shadows.h - exact light visibility: tests one shadow ray for each hit and light.
#pragma once

#include "base/tasks.h"
#include "frame/frame_progress.h"
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

/// Time and work of the stages.
struct ShadowEffort {
    double collect_ms = 0;    // moving hits into the light's space
    double project_ms = 0;    // projecting vertices and triangles onto the light's faces
    double sort_ms = 0;       // sorting samples and triangles into cells
    double test_ms = 0;       // testing triangles against samples
    std::uint64_t points = 0; // shadow rays: (hit, light) pairs that face each other
    TestCounts counts;
};

/// Scratch memory of one worker while it collects a tile's hits.
struct ShadowWorker {
    TileReceivers receivers;
    PointChunk chunk;
};

/// How the triangles of a face are matched with its samples.
enum class ShadowPlan {
    automatic, // chosen from the numbers of triangles and samples
    grid,      // small triangles by the grid (grid_shadows.h), the others by cells
    cells,     // all triangles by patches and cells (irregular/zbuffer.h)
};

/// Memory that is kept from frame to frame.
struct ShadowMemory {
    ShadowPlan plan = ShadowPlan::automatic;
    PencilMesh mesh;
    IrregularMemory irregular;
    SampleGrid grid;
    std::vector<GridTestCounts> grid_counts;       // (threads)
    Buffer<IrregularSample, Pages::small> samples; // (chunks, chunk_room)
    std::vector<FacePatches> face_patches;         // (chunks)
    Buffer<SamplePatch> patches;                   // (chunks) of one face
    Buffer<std::uint8_t> shadowed;                 // (points) of one light
    std::vector<std::unique_ptr<ShadowWorker>> workers;
    ShadowEffort effort; // since the last take_effort()
};

/// Returns the effort since the last call and resets it to zero.
ShadowEffort take_effort(ShadowMemory& memory);

/// Allocates the memory that the chunks and the workers need.
void resize(ShadowMemory& memory, std::size_t chunks, std::size_t points_a_chunk, int threads);

/// Tests the samples of all chunks and writes shadowed[id] = 1 for those that a triangle shadows;
/// other elements are not written. A chunk is a group of points that were collected together: the
/// hits of one tile, or a range of arbitrary points (point_shadows.h). The caller has filled in
/// memory.mesh, memory.samples and memory.face_patches.
void test_chunks(const PencilPoints& points, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed);

/// Light visibility as one bit for each light, tile and sample: 1 where the light reaches the
/// sample. Bits are in tile order: word k of a tile holds its block k.
struct LightVisibilityBits {
    Buffer<std::uint64_t> words; // (lights, tiles, blocks)
    std::size_t lights = 0;
    std::size_t tiles = 0;
    std::size_t blocks = 0; // of one tile

    /// Index of the first word of a light and tile.
    std::size_t first_word(std::size_t light, std::size_t tile) const
    {
        return (light * tiles + tile) * blocks;
    }
};

/// Converts one tile's bits, of all lights, to floats 0 and 1. The result points into `memory`.
LightVisibility unpack_light_visibility(
    const LightVisibilityBits& bits, std::size_t tile, Buffer<float>& memory);

/// The hits whose light visibility is computed.
struct SeenTiles {
    const World& world;
    const glm::dvec3& eye; // where the hits were seen from
    // Of one section of the picture; of equal size, with their items in one array.
    std::span<const HitTile> tiles;
    TileOcclusion* tile_occlusion = nullptr; // of these tiles, with occluders; or null.
                                             // Tiles that it hides are not tested
};

/// Computes which hits one light reaches, as test_exact_shadows does for all lights of the world. The caller
/// has called resize for the tiles.
/// words  (tiles, blocks) receives the answers, in the order of LightVisibilityBits
void test_exact_shadow(const SeenTiles& seen, const Light& light, ShadowMemory& memory,
    Tasks& tasks, std::span<std::uint64_t> words);

/// Computes the light visibility of all hits of the tiles for all lights of the world. A light
/// reaches a hit if it is on the same side of the item's plane as the eye, the hit is inside the
/// light's cone (spot lights), and no other triangle shadows the hit (exact/shadow_ray.h).
/// visibility  receives the answers
/// progress    receives a step for each light
void test_exact_shadows(const SeenTiles& seen, ShadowMemory& memory, Tasks& tasks,
    LightVisibilityBits& visibility, const StageProgress& progress = {});

} // namespace firsthit
