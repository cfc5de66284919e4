// lit_stage.cpp - which lights reach what is seen, by the technique that was asked for.
#include "shadow/lit_stage.h"

#include "shadow/look_up.h"

#include <utility>

namespace firsthit {

void start_lit(const World& world, const Settings& settings, int threads, LitMemory& memory)
{
    memory.technique = settings.shadows == Shadows::map ? Shadows::map : Shadows::exact;
    if (memory.technique == Shadows::map) start_maps(world, threads, memory.maps);
}

void add_lit_hits(const HitTile& hits, LitMemory& memory, std::size_t worker)
{
    if (memory.technique == Shadows::map) add_hits(hits, memory.maps, worker);
}

void find_lit(const World& world, const Settings& settings, const glm::dvec3& eye,
    std::span<const HitTile> tiles, LitMemory& memory, Tasks& tasks)
{
    if (memory.technique == Shadows::map)
        update_maps(world, settings, memory.maps, tasks, memory.map_maker);
    else
        test_exact_shadows(world, eye, tiles, memory.exact, tasks, memory.bits);
}

LitTile lit_of_tile(const World& world, std::span<const HitTile> tiles, std::size_t tile,
    const LitMemory& memory, Buffer<float>& room)
{
    if (memory.technique == Shadows::exact) return unpack_lit(memory.bits, tile, room);
    const std::size_t samples = std::size_t(tiles[tile].size) * std::size_t(tiles[tile].size);
    room.resize(world.lights.size() * samples);
    for (std::size_t l = 0; l < world.lights.size(); ++l)
        look_up(memory.maps, world, tiles[tile], l, room.data() + l * samples);
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
