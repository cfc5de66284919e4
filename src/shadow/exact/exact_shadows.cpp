// exact_shadows.cpp - exact light visibility: one shadow ray for each hit and light.
#include "shadow/exact/exact_shadows.h"

#include "base/stopwatch.h"
#include "hits/hit_position.h"
#include "shadow/exact/collect_hits.h"
#include "shadow/exact/lift_points.h"

#include <bit>
#include <cstring>
#include <optional>
#include <utility>

namespace firsthit {
namespace {

/// The points of the hits. A point's id is the number of its sample, counted through all tiles.
class HitPoints : public PencilPoints {
  public:
    HitPoints(std::span<const HitTile> tiles, const PencilMesh& mesh) : tiles_(tiles), mesh_(mesh)
    {
        item = tiles[0].item;
        ids_rise = true;
    }

    glm::vec3 in_pencil_space(std::uint32_t id) const override
    {
        const std::uint32_t size = std::uint32_t(tiles_[0].size), samples = size * size;
        const HitTile& tile = tiles_[id / samples];
        const std::uint32_t at = id % samples, block = at / kBlockSamples;
        const std::uint32_t blocks_x = size / kBlock;
        const int k = int(at % kBlockSamples);
        const float x = float(block % blocks_x * kBlock) + float(block_x(k)),
                    y = float(block / blocks_x * kBlock) + float(block_y(k));
        const glm::vec3 d = to_light(mesh_.space, hit_position(tile.rays, x, y, tile.t[at]));
        return lift_point(mesh_, tile.item[at], d);
    }

  private:
    std::span<const HitTile> tiles_;
    const PencilMesh& mesh_;
};

/// Triangles per sample above which the grid is faster than sorting both into cells (measured).
constexpr double kManyTrianglesASample = 1.5;

/// The grid is not used where its cells hold more than this many samples on average around a
/// sample (SampleGrid::crowding); eight are usual.
constexpr double kCrowded = 128;

bool wants_grid(const ShadowMemory& memory, std::size_t samples)
{
    if (memory.plan != ShadowPlan::automatic) return memory.plan == ShadowPlan::grid;
    return double(memory.mesh.index.size()) > kManyTrianglesASample * double(samples);
}

} // namespace

LightVisibility unpack_light_visibility(
    const LightVisibilityBits& bits, std::size_t tile, Buffer<float>& memory)
{
    const std::size_t samples = bits.blocks * kBlockSamples;
    memory.resize(bits.lights * samples);
    for (std::size_t l = 0; l < bits.lights; ++l)
        unpack_bits(bits.words.span().subspan(bits.first_word(l, tile), bits.blocks),
            memory.data() + l * samples);
    return {memory.data(), samples};
}

void resize(ShadowMemory& memory, std::size_t chunks, std::size_t points_a_chunk, int threads)
{
    memory.samples.resize(chunks * chunk_room(points_a_chunk));
    if (memory.face_patches.size() < chunks) memory.face_patches.resize(chunks);
    memory.patches.resize(chunks);
    memory.shadowed.resize(chunks * points_a_chunk);
    while (int(memory.workers.size()) < threads)
        memory.workers.push_back(std::make_unique<ShadowWorker>());
    if (int(memory.grid_counts.size()) < threads) memory.grid_counts.resize(std::size_t(threads));
    for (const auto& worker : memory.workers) {
        worker->chunk.reserve(points_a_chunk);
        worker->receivers.run.resize(points_a_chunk);
    }
}

ShadowEffort take_effort(ShadowMemory& memory)
{
    for (const auto& worker : memory.irregular.workers) {
        memory.effort.counts.add(worker->kernel.counts);
        worker->kernel.counts = {};
    }
    for (GridTestCounts& worker : memory.grid_counts) {
        memory.effort.counts.add(worker.counts);
        worker.counts = {};
    }
    return std::exchange(memory.effort, {});
}

/// The samples that lie on one face.
struct FaceSamples {
    const CubeFace& face;
    const SampleBounds& bounds;
};

/// Tests the samples of one face by the grid. Returns the number of triangles that the grid left
/// untested. Returns nothing, and tests nothing, where the samples are too crowded for the grid.
std::optional<std::size_t> test_face_by_grid(const FaceSamples& samples, const PencilPoints& points,
    ShadowMemory& memory, Tasks& tasks, std::span<std::uint8_t> shadowed)
{
    const auto& [face, bounds] = samples;
    Stopwatch watch;
    const bool sorted = sort_into_grid({memory.samples.span(), memory.patches.span(), bounds},
        {face.directional, prefers_strips_along_y(memory.mesh, face, bounds)}, points, memory.grid,
        tasks);
    memory.effort.sort_ms += watch.lap_ms();
    if (!sorted || (memory.plan != ShadowPlan::grid && memory.grid.crowding > kCrowded)) return {};
    quantize_all_vertices(face, memory.grid.axes, memory.mesh, tasks);
    memory.effort.project_ms += watch.lap_ms();
    const std::size_t left =
        test_grid(memory.mesh, {memory.grid, points, shadowed}, memory.grid_counts, tasks);
    memory.effort.test_ms += watch.lap_ms();
    if (left > 0) project_all_vertices(face, memory.mesh, tasks); // for the triangles left
    memory.effort.project_ms += watch.lap_ms();
    return left;
}

void test_chunks(const PencilPoints& points, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed)
{
    const std::size_t chunks = memory.patches.size();
    ShadowEffort& effort = memory.effort;
    for (std::size_t face = 0; face < kCubeFaces; ++face) {
        SampleBounds bounds;
        std::size_t count = 0;
        for (std::size_t k = 0; k < chunks; ++k) {
            const SamplePatch& patch = memory.patches[k] = memory.face_patches[k][face];
            if (patch.range.count == 0) continue;
            bounds.add(patch.bounds);
            count += patch.range.count;
        }
        if (count == 0) continue;
        effort.points += count;
        const CubeFace seen_by = cube_face(memory.mesh.space.directional, int(face));
        std::optional<std::size_t> left;
        if (wants_grid(memory, count))
            left = test_face_by_grid({seen_by, bounds}, points, memory, tasks, shadowed);
        if (left == std::size_t(0)) continue;
        Stopwatch watch;
        if (!left) find_triangles_in_view(seen_by, bounds, memory.mesh, tasks);
        effort.project_ms += watch.lap_ms();
        sort_face(memory.mesh, {memory.samples.span(), memory.patches.span(), bounds}, points,
            memory.irregular, tasks);
        effort.sort_ms += watch.lap_ms();
        test_face(memory.mesh, points, memory.irregular, tasks, shadowed);
        effort.test_ms += watch.lap_ms();
    }
}

void test_exact_shadow(const SeenTiles& seen, const Light& light, ShadowMemory& memory,
    Tasks& tasks, std::span<std::uint64_t> words)
{
    const World& world = seen.world;
    const std::span<const HitTile> tiles = seen.tiles;
    TileOcclusion* const tile_occlusion = seen.tile_occlusion;
    const std::size_t size = std::size_t(tiles[0].size), samples = size * size;
    const std::size_t blocks = samples / kBlockSamples;
    const PencilSpace space =
        light_space(light, seen.eye, farthest_coordinate(light, world.position));
    std::optional<SpotCone> cone;
    if (light.kind == Light::Kind::spot) cone = spot_cone(light);
    Stopwatch watch;
    if (tile_occlusion && find_occluded_tiles(world, space, tiles, *tile_occlusion, tasks)) {
        std::fill(words.begin(), words.end(), std::uint64_t(0));
        memory.effort.collect_ms += watch.lap_ms();
        return;
    }
    memory.effort.collect_ms += watch.lap_ms();
    memory.mesh.cutouts.find(*world.scene, kShadowOpacity);
    make_pencil_mesh(space, world.position, world.scene->index, memory.mesh, tasks);
    memory.effort.project_ms += watch.lap_ms();
    tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t worker) {
        const std::span<std::uint64_t> reached = words.subspan(tile * blocks, blocks);
        if (tile_occlusion && tile_occlusion->hidden[tile]) {
            std::fill(reached.begin(), reached.end(), std::uint64_t(0));
            memory.face_patches[tile] = {};
            return;
        }
        TileReceivers& receivers = memory.workers[worker]->receivers;
        PointChunk& chunk = memory.workers[worker]->chunk;
        find_receivers(memory.mesh, tiles[tile], receivers);
        collect_hits({tiles[tile], receivers.runs(), memory.mesh, cone ? &*cone : nullptr,
                         std::uint32_t(tile * samples)},
            {memory.samples.span(), tile * chunk_room(samples)}, reached, memory.face_patches[tile],
            chunk);
        std::memset(memory.shadowed.data() + tile * samples, 0, samples);
    });
    memory.effort.collect_ms += watch.lap_ms();
    test_chunks(HitPoints(tiles, memory.mesh), memory, tasks, memory.shadowed.span());
    watch.lap_ms();
    tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t) {
        remove_shadowed(
            memory.shadowed.data() + tile * samples, words.subspan(tile * blocks, blocks));
    });
    memory.effort.collect_ms += watch.lap_ms();
}

void test_exact_shadows(const SeenTiles& seen, ShadowMemory& memory, Tasks& tasks,
    LightVisibilityBits& visibility, const StageProgress& progress)
{
    const std::span<const HitTile> tiles = seen.tiles;
    const std::size_t lights = seen.world.lights.size();
    const std::size_t size = std::size_t(tiles[0].size), samples = size * size;
    visibility.lights = lights;
    visibility.tiles = tiles.size();
    visibility.blocks = samples / kBlockSamples;
    visibility.words.resize(lights * visibility.tiles * visibility.blocks);
    resize(memory, tiles.size(), samples, tasks.threads());
    for (std::size_t l = 0; l < lights; ++l) {
        test_exact_shadow(seen, seen.world.lights[l], memory, tasks,
            visibility.words.span().subspan(
                visibility.first_word(l, 0), visibility.tiles * visibility.blocks));
        progress.step(l, lights);
    }
}

} // namespace firsthit
