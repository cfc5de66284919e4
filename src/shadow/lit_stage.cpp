// lit_stage.cpp - which lights reach what is seen, by the technique that was asked for.
#include "shadow/lit_stage.h"

#include "shadow/look_up.h"

#include <algorithm>
#include <utility>

namespace firsthit {

namespace {

/// Finds the lights that reach no hit at all, and what the others' maps have to show: bounds are asked for
/// only now where there are walls.
void find_dark_lights(const World& world, const glm::dvec3& eye, std::span<const HitTile> tiles,
    LitMemory& memory, Tasks& tasks)
{
    for (std::size_t light = 0; light < world.lights.size(); ++light) {
        memory.dark[light] =
            find_umbra(world, light_space(world.lights[light], eye), tiles, memory.umbra, tasks);
        if (memory.dark[light]) continue;
        tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t worker) {
            add_hits(tiles[tile], light, memory.maps, worker);
        });
    }
}

} // namespace

void start_lit(const World& world, const Settings& settings, std::size_t tiles, LitMemory& memory,
    Tasks& tasks)
{
    memory.technique = settings.shadows == Shadows::map ? Shadows::map : Shadows::exact;
    memory.dark.assign(world.lights.size(), 0);
    // A bias that is given may let light through a wall.
    const bool by_map = memory.technique == Shadows::map;
    if (memory.by_walls && !(by_map && settings.shadow_bias >= 0))
        start_umbra(world, tiles, memory.umbra, tasks);
    else
        memory.umbra.walls.resize(0);
    if (by_map) start_maps(world, tasks.threads(), memory.maps);
}

void add_lit_hits(const HitTile& hits, std::size_t tile, LitMemory& memory, std::size_t worker)
{
    if (memory.umbra.has_walls())
        add_hits(hits, tile, memory.umbra);
    else if (memory.technique == Shadows::map)
        add_hits(hits, memory.maps, worker);
}

void find_lit(const World& world, const Settings& settings, const glm::dvec3& eye,
    std::span<const HitTile> tiles, LitMemory& memory, Tasks& tasks)
{
    const bool walls = memory.umbra.has_walls();
    if (memory.technique == Shadows::exact) {
        test_exact_shadows(
            world, eye, tiles, memory.exact, tasks, memory.bits, walls ? &memory.umbra : nullptr);
        return;
    }
    if (walls) find_dark_lights(world, eye, tiles, memory, tasks);
    update_maps(world, settings, memory.maps, tasks, memory.map_maker);
}

LitTile lit_of_tile(const World& world, std::span<const HitTile> tiles, std::size_t tile,
    const LitMemory& memory, Buffer<float>& room)
{
    if (memory.technique == Shadows::exact) return unpack_lit(memory.bits, tile, room);
    const std::size_t samples = std::size_t(tiles[tile].size) * std::size_t(tiles[tile].size);
    room.resize(world.lights.size() * samples);
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        float* lit = room.data() + l * samples;
        if (memory.dark[l])
            std::fill_n(lit, samples, 0.0f);
        else
            look_up(memory.maps, world, tiles[tile], l, lit);
    }
    return {room.data(), samples};
}

void add_lit_stats(LitMemory& memory, Stats& stats)
{
    stats.map_updates += std::exchange(memory.maps.updates, 0);
    const ShadowEffort effort = take_effort(memory.exact);
    stats.shadow_collect_ms += effort.collect_ms;
    stats.shadow_sort_ms += effort.see_ms + effort.sort_ms;
    stats.shadow_test_ms += effort.test_ms;
    stats.shadow_points += effort.points;
    stats.shadow_triangles += effort.counts.triangles;
    stats.shadow_pairs += effort.counts.pairs;
    stats.shadow_uncertain += effort.counts.uncertain;
    stats.exact_calls += effort.counts.effort.exact_calls;
}

} // namespace firsthit
