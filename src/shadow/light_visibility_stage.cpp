// light_visibility_stage.cpp - the stage of a frame that finds which lights reach the hits.
#include "shadow/light_visibility_stage.h"

#include "shadow/map/sample_shadow_map.h"

#include <algorithm>
#include <utility>

namespace firsthit {

namespace {

/// Finds the lights that reach no hit at all. For the other lights, adds the bounds of the hits to
/// the maps, which add_light_visibility_hits leaves to this function if there are occluders.
void find_dark_lights(const World& world, const glm::dvec3& eye, std::span<const HitTile> tiles,
    LightVisibilityMemory& memory, Tasks& tasks)
{
    for (std::size_t light = 0; light < world.lights.size(); ++light) {
        memory.dark[light] = find_occluded_tiles(world,
            light_space(
                world.lights[light], eye, farthest_coordinate(world.lights[light], world.position)),
            tiles, memory.tile_occlusion, tasks);
        if (memory.dark[light]) continue;
        tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t worker) {
            add_hits(tiles[tile], light, memory.maps, worker);
        });
    }
}

} // namespace

void start_light_visibility(const World& world, const ShadowOptions& options, std::size_t tiles,
    LightVisibilityMemory& memory, Tasks& tasks)
{
    memory.technique = options.shadows == Shadows::map ? Shadows::map : Shadows::exact;
    memory.options = options;
    memory.dark.assign(world.lights.size(), 0);
    // With a bias from the settings a map may show no shadow behind an occluder, so that culling
    // would change the picture.
    const bool by_map = memory.technique == Shadows::map;
    if (memory.by_occluders && !(by_map && options.shadow_bias >= 0))
        start_tile_occlusion(world, tiles, memory.tile_occlusion, tasks);
    else
        memory.tile_occlusion.occluders.resize(0);
    if (by_map) start_maps(world, tasks.threads(), memory.maps);
}

void add_light_visibility_hits(
    const HitTile& hits, std::size_t tile, LightVisibilityMemory& memory, std::size_t worker)
{
    if (memory.tile_occlusion.has_occluders())
        add_hits(hits, tile, memory.tile_occlusion);
    else if (memory.technique == Shadows::map)
        add_hits(hits, memory.maps, worker);
}

void find_light_visibility(const FrameContext& frame, std::span<const HitTile> tiles,
    LightVisibilityMemory& memory, std::uint64_t work)
{
    const World& world = frame.world;
    const glm::dvec3& eye = frame.view.camera.eye;
    const StageProgress progress{frame.progress, work};
    const bool occluders = memory.tile_occlusion.has_occluders();
    if (memory.technique == Shadows::exact) {
        test_exact_shadows({world, eye, tiles, occluders ? &memory.tile_occlusion : nullptr},
            memory.exact, frame.tasks, memory.bits, progress);
        return;
    }
    if (occluders) find_dark_lights(world, eye, tiles, memory, frame.tasks);
    update_maps(world, memory.options, memory.maps, frame.tasks, {memory.map_maker, progress});
}

LightVisibility light_visibility_of_tile(const World& world, std::span<const HitTile> tiles,
    std::size_t tile, const LightVisibilityMemory& memory, Buffer<float>& room)
{
    if (memory.technique == Shadows::exact) return unpack_light_visibility(memory.bits, tile, room);
    const std::size_t samples = std::size_t(tiles[tile].size) * std::size_t(tiles[tile].size);
    room.resize(world.lights.size() * samples);
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        float* lit = room.data() + l * samples;
        if (memory.dark[l])
            std::fill_n(lit, samples, 0.0f);
        else
            sample_shadow_map(memory.maps, world, tiles[tile], l, lit);
    }
    return {room.data(), samples};
}

void add_light_visibility_stats(LightVisibilityMemory& memory, Stats& stats)
{
    stats.map_updates += std::exchange(memory.maps.updates, 0);
    const ShadowEffort effort = take_effort(memory.exact);
    stats.shadow_collect_ms += effort.collect_ms;
    stats.shadow_sort_ms += effort.project_ms + effort.sort_ms;
    stats.shadow_test_ms += effort.test_ms;
    stats.shadow_points += effort.points;
    stats.shadow_triangles += effort.counts.triangles;
    stats.shadow_pairs += effort.counts.pairs;
    stats.shadow_uncertain += effort.counts.uncertain;
    stats.exact_calls += effort.counts.effort.exact_calls;
}

} // namespace firsthit
