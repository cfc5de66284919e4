// frame.cpp - the cpu engine: a picture from a posed world, tile by tile.
#include "cpu/frame.h"

#include "base/stopwatch.h"
#include "cpu/film_planes.h"
#include "visibility/bins.h"
#include "visibility/project.h"
#include "visibility/raster_tile.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace firsthit {
namespace {

/// One pass over the picture: which rays, and what is kept of them.
struct Pass {
    int samples = 1; // on a pixel's side
    bool color = true;
    std::span<const Aov> aovs;
    bool shadows = false; // to be found for the colour
};

/// Samples on a tile's side: whole blocks and whole pixels.
int tile_samples(int tile_size, int samples)
{
    const int step = std::lcm(kBlock, samples);
    return std::min((tile_size + step - 1) / step * step, kMaxTile / step * step);
}

/// Triangles to the tiles of one part of the picture; false where there are too many (bins.h).
bool see_triangles(const World& world, const View& view, const Region& part, int samples,
    int tile_size, ViewMemory& memory, Tasks& tasks)
{
    memory.pencil = pencil_of(view, part, samples);
    memory.tile_size = tile_size;
    memory.tiles_x = (memory.pencil.width + tile_size - 1) / tile_size;
    memory.tiles_y = (memory.pencil.height + tile_size - 1) / tile_size;
    const int longest = std::max(memory.pencil.width, memory.pencil.height);
    memory.tile_of.resize(std::size_t(longest));
    for (int k = 0; k < longest; ++k) memory.tile_of[std::size_t(k)] = std::uint8_t(k / tile_size);
    project_vertices(world.position, memory, tasks);
    return bin_triangles(world.scene->index, memory, tasks);
}

/// The part cut in two between tiles, across its longer side.
std::array<Region, 2> halves(const Region& part, int tile_pixels)
{
    Region first = part, second = part;
    const auto cut = [&](int size) { return (size / tile_pixels + 1) / 2 * tile_pixels; };
    if (part.width >= part.height) {
        first.width = cut(part.width);
        second.x += first.width;
        second.width -= first.width;
    } else {
        first.height = cut(part.height);
        second.y += first.height;
        second.height -= first.height;
    }
    return {first, second};
}

/// The tile's items and hits. Which triangle does each sample see, and where exactly?
HitTile see_tile(FrameMemory& memory, std::size_t tile, std::size_t place, TileWorker& worker)
{
    Stopwatch lap;
    raster_tile(memory.view, int(tile), worker.items);
    worker.raster_ms += lap.lap_ms();
    const HitTile hits = resolve_tile(memory.view, worker.items, memory.hits.of(place));
    worker.resolve_ms += lap.lap_ms();
    worker.counts.uncertain += worker.items.counts.uncertain;
    worker.counts.ambiguous += worker.items.counts.ambiguous;
    worker.counts.effort.exact_calls += worker.items.counts.effort.exact_calls;
    worker.hit_count += count_hits(hits);
    return hits;
}

/// Items, hits and colours of one part of the picture. Where shadows have to be found, all tiles'
/// hits are kept for the lights; else each tile is finished while it is in cache.
void render_part(const World& world, const View& view, const Region& part, const Pass& pass,
    int tile_size, FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    Stopwatch watch;
    const bool seen = see_triangles(world, view, part, pass.samples, tile_size, memory.view, tasks);
    stats.setup_ms += watch.lap_ms();
    if (!seen) {
        for (const Region& half : halves(part, tile_size / pass.samples))
            render_part(world, view, half, pass, tile_size, memory, tasks, film, stats);
        return;
    }

    const std::size_t tiles = std::size_t(memory.view.tiles());
    resize(memory.hits, tile_size, pass.shadows ? tiles : std::size_t(tasks.threads()));
    const auto finish = [&](const HitTile& hits, std::size_t tile, TileWorker& worker) {
        Stopwatch lap;
        LitTile lit;
        if (pass.shadows) lit = unpack_lit(memory.lit, tile, worker.lit);
        shade_tile(hits, world, lit, worker.shade.targets); // what colour is it?
        store_tile({memory.view, part, view.region, pass.samples, int(tile)}, hits, lit,
            worker.shade.targets, film);
        worker.shade_ms += lap.lap_ms();
    };
    if (pass.shadows) {
        memory.tiles.resize(tiles);
        tasks.for_each(tiles, [&](std::size_t tile, std::size_t worker) {
            memory.tiles[tile] = see_tile(memory, tile, tile, *memory.workers[worker]);
        });
        watch.lap_ms();
        test_exact_shadows(world, view.camera.eye, memory.tiles, memory.shadows, tasks,
            memory.lit); // which lights reach it?
        memory.shadow_ms += watch.lap_ms();
        tasks.for_each(tiles, [&](std::size_t tile, std::size_t worker) {
            finish(memory.tiles[tile], tile, *memory.workers[worker]);
        });
    } else {
        tasks.for_each(tiles, [&](std::size_t tile, std::size_t worker) {
            TileWorker& own = *memory.workers[worker];
            finish(see_tile(memory, tile, worker, own), tile, own);
        });
    }
    stats.in_view += memory.view.in_view_count;
    stats.tile_entries += memory.view.entry_count;
}

/// Prepares every worker's tile memory, and the planes of the film that the pass fills.
void prepare(const Pass& pass, int tile_size, const World& world, const View& view,
    FrameMemory& memory, Tasks& tasks, Film& film)
{
    while (int(memory.workers.size()) < tasks.threads())
        memory.workers.push_back(std::make_unique<TileWorker>());
    for (const auto& worker : memory.workers) {
        resize(worker->items, tile_size);
        resize(worker->shade, tile_size, pass.color, pass.aovs);
    }
    resize(film, view.region.width, view.region.height, pass.color, pass.aovs, world.lights.size());
}

void render_pass(const World& world, const View& view, const Pass& pass, int tile_size,
    FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    const int tile = tile_samples(tile_size, pass.samples);
    prepare(pass, tile, world, view, memory, tasks, film);
    // Parts small enough for the boxes' and tiles' integers, in whole tiles.
    const int step = std::min(kMaxPencil, 255 * tile) / tile * tile / pass.samples;
    const Region& all = view.region;
    for (int y = 0; y < all.height; y += step) {
        for (int x = 0; x < all.width; x += step) {
            const Region part{all.x + x, all.y + y, std::min(step, all.width - x),
                std::min(step, all.height - y)};
            render_part(world, view, part, pass, tile, memory, tasks, film, stats);
        }
    }
}

/// Moves the workers' times and counts to the statistics.
void collect(FrameMemory& memory, int threads, Stats& stats)
{
    for (const auto& worker : memory.workers) {
        stats.raster_ms += worker->raster_ms / threads;
        stats.resolve_ms += worker->resolve_ms / threads;
        stats.shade_ms += worker->shade_ms / threads;
        stats.uncertain_lanes += worker->counts.uncertain;
        stats.ambiguous_lanes += worker->counts.ambiguous;
        stats.exact_calls += worker->counts.effort.exact_calls;
        stats.hits += worker->hit_count;
        worker->raster_ms = worker->resolve_ms = worker->shade_ms = 0;
        worker->counts = {};
        worker->hit_count = 0;
    }
}

} // namespace

void render_frame(const World& world, const View& view, const Settings& settings,
    FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    film.width = view.region.width;
    film.height = view.region.height;
    clear_unused(film, settings.color, settings.aovs);
    // Planes are of the ray through the pixel's centre: with several samples they are a second
    // pass.
    const bool together = settings.samples == 1;
    const std::span<const Aov> aovs = settings.aovs;
    if (settings.color || together)
        render_pass(world, view,
            {settings.samples, settings.color, together ? aovs : std::span<const Aov>(),
                settings.color && settings.shadows == Shadows::exact && !world.lights.empty()},
            settings.tile_size, memory, tasks, film, stats);
    if (!together && !aovs.empty())
        render_pass(world, view, {1, false, aovs}, settings.tile_size, memory, tasks, film, stats);
    collect(memory, tasks.threads(), stats);
}

} // namespace firsthit
