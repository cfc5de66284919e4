// embree_frame.cpp - the cpu engine's frame, with a tree and rays in the place of rasterising.
#include "baseline/embree_frame.h"

#include "base/stopwatch.h"
#include "cpu/film_planes.h"
#include "film/film_size.h"

#include <algorithm>

namespace firsthit {
namespace {

void lay_out(const View& view, int tile_size, ViewMemory& memory)
{
    memory.pencil = pencil_of(view, view.region, 1);
    memory.tile_size = tile_size;
    memory.tiles_x = (view.region.width + tile_size - 1) / tile_size;
    memory.tiles_y = (view.region.height + tile_size - 1) / tile_size;
}

EmbreeTile tile_of(const ViewMemory& view, const EmbreeTree& tree, int packet, int tile)
{
    const Pencil& pencil = view.pencil;
    const int x = tile % view.tiles_x * view.tile_size, y = tile / view.tiles_x * view.tile_size;
    EmbreeTile rays;
    rays.scene = tree.scene();
    rays.first_triangle = tree.first_triangle();
    rays.packet = packet;
    rays.size = view.tile_size;
    rays.width = std::min(view.tile_size, pencil.width - x);
    rays.height = std::min(view.tile_size, pencil.height - y);
    rays.frame.x0 = float(pencil.x0 + x);
    rays.frame.y0 = float(pencil.y0 + y);
    rays.frame.inv_f = float(1 / pencil.f);
    rays.frame.eye = glm::vec3(pencil.eye);
    rays.frame.world_from_eye = glm::mat3(pencil.world_from_axes);
    return rays;
}

void prepare(const World& world, const View& view, const Settings& settings,
    EmbreeFrameMemory& memory, Tasks& tasks, Film& film)
{
    const auto threads = std::size_t(tasks.threads());
    const auto samples = std::size_t(settings.tile_size) * std::size_t(settings.tile_size);
    lay_out(view, settings.tile_size, memory.view);
    resize(memory.hits, settings.tile_size, threads);
    while (memory.workers.size() < threads)
        memory.workers.push_back(std::make_unique<EmbreeWorker>());
    for (const auto& worker : memory.workers) {
        resize(worker->shade, settings.tile_size, settings.color, settings.aovs);
        worker->lit.resize(world.lights.size() * samples);
    }
    film.width = view.region.width;
    film.height = view.region.height;
    clear_unused(film, settings.color, settings.aovs);
    resize(film, film.width, film.height, settings.color, settings.aovs, world.lights.size());
}

/// Moves the workers' times and counts to the statistics.
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

void render_embree(const World& world, const View& view, const Settings& settings,
    const EmbreeTree& tree, int packet, EmbreeFrameMemory& memory, Tasks& tasks, Film& film,
    BaselineStats& stats)
{
    prepare(world, view, settings, memory, tasks, film);
    const bool shadows = settings.shadows != Shadows::none && !world.lights.empty();
    const std::span<const Light> lights =
        shadows ? std::span<const Light>(world.lights) : std::span<const Light>();
    tasks.for_each(std::size_t(memory.view.tiles()), [&](std::size_t tile, std::size_t number) {
        EmbreeWorker& worker = *memory.workers[number];
        Stopwatch lap;
        const EmbreeTile rays = tile_of(memory.view, tree, packet, int(tile));
        const HitTile hits = see_embree(rays, memory.hits.of(number), lights, worker.tile);
        worker.hits += count_hits(hits);
        worker.primary_ms += lap.lap_ms();
        LightVisibility lit;
        if (shadows) {
            worker.shadow_rays +=
                find_light_visibility_embree(rays, hits, lights, worker.tile, worker.lit.data());
            lit = {worker.lit.data(), std::size_t(hits.size) * std::size_t(hits.size)};
        }
        worker.shadow_ms += lap.lap_ms();
        shade_tile(hits, world, lit, worker.shade.targets);
        store_tile({memory.view, view.region, view.region, 1, int(tile)}, hits, lit,
            worker.shade.targets, film);
        worker.shade_ms += lap.lap_ms();
    });
    collect(memory, tasks.threads(), stats);
}

} // namespace firsthit
