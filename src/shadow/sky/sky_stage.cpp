// sky_stage.cpp - the stage of a frame that finds which directions of the sky the hits see.
#include "shadow/sky/sky_stage.h"

#include "base/stopwatch.h"

#include <utility>

namespace firsthit {
namespace {

/// Makes the directions, unless they are known from the frame before.
void make_directions(const SkyWork& work, SkyMemory& memory)
{
    const glm::dvec3 zenith = zenith_of(work.sky, work.camera_up);
    if (memory.known != work.sky.directions || memory.known_zenith != zenith)
        fill_sky_directions(work.sky.directions, zenith, memory.directions);
    memory.known = work.sky.directions;
    memory.known_zenith = zenith;
    set_up_sky(work.sky, zenith, memory.directions, memory.rays);
}

/// Puts the answers of direction k beside those of the other directions.
void keep_answer(std::size_t k, SkyMemory& memory, Tasks& tasks)
{
    constexpr std::size_t kGrain = 4096; // blocks
    const std::size_t count = memory.rays.count();
    tasks.for_ranges(memory.answer.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t block = first; block < last; ++block)
            memory.words[block * count + k] = memory.answer[block];
    });
}

} // namespace

void find_sky_visibility(
    const SkyWork& work, ShadowMemory& shadows, SkyMemory& memory, Tasks& tasks)
{
    Stopwatch watch;
    const std::span<const HitTile> tiles = work.seen.tiles;
    const std::size_t size = std::size_t(tiles[0].size), samples = size * size;
    make_directions(work, memory);
    const std::size_t count = memory.rays.count();
    memory.blocks = samples / kBlockSamples;
    memory.answer.resize(tiles.size() * memory.blocks);
    memory.words.resize(memory.answer.size() * count);
    resize(shadows, tiles.size(), samples, tasks.threads());
    const ShadowEffort of_lights = take_effort(shadows);
    for (std::size_t k = 0; k < count; ++k) {
        test_exact_shadow(
            work.seen, sky_ray_light(memory.directions[k]), shadows, tasks, memory.answer.span());
        keep_answer(k, memory, tasks);
        work.progress.step(k, count);
    }
    const ShadowEffort effort = take_effort(shadows);
    memory.effort.points += effort.points;
    memory.effort.counts.add(effort.counts);
    shadows.effort = of_lights;
    memory.ms += watch.lap_ms();
}

SkyVisibility sky_visibility_of_tile(const SkyMemory& memory, std::size_t tile)
{
    return {memory.words.data() + tile * memory.blocks * memory.rays.count(), &memory.rays};
}

void add_sky_stats(SkyMemory& memory, Stats& stats)
{
    stats.sky_ms += std::exchange(memory.ms, 0);
    const ShadowEffort effort = std::exchange(memory.effort, {});
    stats.sky_points += effort.points;
    stats.exact_calls += effort.counts.effort.exact_calls;
}

} // namespace firsthit
