// embree_frame.cpp - the frame of the baseline: that of the cpu engine, but Embree's tree and rays
// replace rasterising.
#include "baseline/embree_frame.h"

#include "base/stopwatch.h"
#include "cpu/film_planes.h"
#include "film/film_size.h"

#include <firsthit/error.h>

#include <algorithm>

namespace firsthit {
namespace {

EmbreeTile tile_of(const TileLayout& layout, const EmbreeRays& rays, int tile)
{
    const Pencil& pencil = layout.pencil;
    const int x = layout.first_x(tile), y = layout.first_y(tile);
    EmbreeTile to_shoot;
    to_shoot.scene = rays.tree.scene();
    to_shoot.first_triangle = rays.tree.first_triangle();
    to_shoot.packet = rays.packet;
    to_shoot.size = layout.tile_size;
    to_shoot.width = std::min(layout.tile_size, pencil.width - x);
    to_shoot.height = std::min(layout.tile_size, pencil.height - y);
    to_shoot.rays = world_rays(pencil, pencil.tile(x, y));
    return to_shoot;
}

/// Lays out the tiles, and prepares the memory and the film.
void prepare(const FrameContext& frame, const Settings& settings, EmbreeFrameMemory& memory)
{
    const std::size_t lights = frame.world.lights.size();
    const auto threads = std::size_t(frame.tasks.threads());
    const auto samples = std::size_t(settings.tile_size) * std::size_t(settings.tile_size);
    if (frame.view.camera.orthographic_height)
        throw ArgumentError(
            "the baseline has no orthographic cameras: choose one with a field of view");
    lay_out(pencil_of(frame.view, frame.view.region, 1), settings.tile_size, memory.layout);
    resize(memory.hits, settings.tile_size, threads);
    while (memory.workers.size() < threads)
        memory.workers.push_back(std::make_unique<EmbreeWorker>());
    for (const auto& worker : memory.workers) {
        resize(worker->shade, settings.tile_size, settings.color, settings.aovs);
        worker->lit.resize(lights * samples);
    }
    resize(frame.film, frame.view.region, {settings.color, settings.aovs, lights});
}

/// Adds the workers' times and counts to the statistics and sets them to 0.
void collect(EmbreeFrameMemory& memory, int threads, BaselineStats& stats)
{
    for (const auto& worker : memory.workers) {
        stats.primary_ms += worker->primary_ms / threads;
        stats.shadow_ms += worker->shadow_ms / threads;
        stats.shade_ms += worker->shade_ms / threads;
        stats.hits += worker->hits;
        stats.shadow_rays += worker->shadow_rays;
        worker->primary_ms = worker->shadow_ms = worker->shade_ms = 0;
        worker->hits = worker->shadow_rays = 0;
    }
}

} // namespace

void render_embree(const FrameContext& frame, const Settings& settings, const EmbreeRays& rays,
    EmbreeFrameMemory& memory, BaselineStats& stats)
{
    const World& world = frame.world;
    const Region& region = frame.view.region;
    prepare(frame, settings, memory);
    const bool shadows = settings.shadows != Shadows::none && !world.lights.empty();
    const std::span<const Light> lights =
        shadows ? std::span<const Light>(world.lights) : std::span<const Light>();
    frame.tasks.for_each(
        std::size_t(memory.layout.tiles()), [&](std::size_t tile, std::size_t number) {
            EmbreeWorker& worker = *memory.workers[number];
            Stopwatch lap;
            const EmbreeTile of = tile_of(memory.layout, rays, int(tile));
            const HitTile hits = see_embree(of, memory.hits.of(number), lights, worker.tile);
            worker.hits += count_hits(hits);
            worker.primary_ms += lap.lap_ms();
            LightVisibility lit;
            if (shadows) {
                worker.shadow_rays +=
                    find_light_visibility_embree(of, hits, lights, worker.tile, worker.lit.data());
                lit = {worker.lit.data(), std::size_t(hits.size) * std::size_t(hits.size)};
            }
            worker.shadow_ms += lap.lap_ms();
            shade_tile(hits, world, lit, worker.shade.targets);
            store_tile({memory.layout, region, region, 1, int(tile)}, hits, lit,
                worker.shade.targets, frame.film);
            worker.shade_ms += lap.lap_ms();
        });
    collect(memory, frame.tasks.threads(), stats);
}

} // namespace firsthit
