// frame.cpp - the cpu engine: a picture from a posed world, tile by tile.
#include "cpu/frame.h"

#include "base/stopwatch.h"
#include "cpu/film_planes.h"
#include "cpu/tile_stages.h"
#include "film/film_size.h"
#include "visibility/raster/raster_tile.h"

#include <algorithm>
#include <array>

namespace firsthit {
namespace {

/// Lays out the part's rays, tiles and memory, and has its items begun.
/// returns  whether the part is small enough
bool begin_part(const FramePart& part)
{
    const FrameContext& frame = part.frame;
    const PassPlan& pass = part.pass;
    FrameMemory& memory = part.memory;
    lay_out(pencil_of(frame.view, part.pixels, pass.samples), pass.tile_size, memory.view);
    if (!part.items.start(frame.world, memory.view, frame.tasks)) return false;
    const auto tiles = std::size_t(memory.view.tiles());
    const std::size_t kept = pass.shadows ? tiles : std::size_t(frame.tasks.threads());
    resize(memory.hits, pass.tile_size, kept);
    resize(memory.holes, pass.tile_size, kept);
    memory.hits.items = pass.keeps_items;
    memory.hits.misses = pass.keeps_misses;
    if (pass.shadows) {
        memory.tiles.resize(tiles);
        start_light_visibility(frame.world, part.plan.shadows(), tiles, memory.lit, frame.tasks);
    }
    return true;
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

std::uint64_t tile_work(const FramePart& part, std::size_t tile)
{
    const PixelRect rect = pixels_of(
        {part.memory.view, part.pixels, part.frame.view.region, part.pass.samples, int(tile)});
    return part.pass.samples_of({0, 0, rect.width, rect.height});
}

/// Calls body(tile, worker) for all tiles, as their items become ready.
template <class Body>
void for_ready_tiles(const FramePart& part, const Body& body)
{
    const auto tiles = std::size_t(part.memory.view.tiles());
    for (std::size_t done = 0; done < tiles;) {
        const std::size_t ready = part.items.wait(part.memory.view);
        part.frame.tasks.for_each(ready - done, [&](std::size_t k, std::size_t worker) {
            body(done + k, worker);
            part.frame.add(tile_work(part, done + k), worker);
        });
        done = ready;
    }
}

/// Each tile from its items to its colours while it is in cache.
void render_tiles(const FramePart& part)
{
    for_ready_tiles(part, [&](std::size_t tile, std::size_t worker) {
        const TileTurn turn{tile, worker, worker};
        find_items(part, turn);
        shade_and_store(part, turn, find_hits(part, turn), {});
    });
}

/// All tiles' hits are kept until the lights' shadows on them are known.
void render_tiles_in_shadow(const FramePart& part, Stats& stats)
{
    const FrameContext& frame = part.frame;
    FrameMemory& memory = part.memory;
    for_ready_tiles(part, [&](std::size_t tile, std::size_t worker) {
        const TileTurn turn{tile, tile, worker};
        find_items(part, turn);
        memory.tiles[tile] = find_hits(part, turn);
        add_light_visibility_hits(memory.tiles[tile], tile, memory.lit, worker);
    });
    Stopwatch watch;
    find_light_visibility(frame, memory.tiles, memory.lit, part.pass.samples_of(part.pixels));
    stats.shadow_ms += watch.lap_ms();
    frame.tasks.for_each(memory.tiles.size(), [&](std::size_t tile, std::size_t worker) {
        const TileTurn turn{tile, tile, worker};
        const LightVisibility lit = light_visibility(part, turn);
        shade_and_store(part, turn, memory.tiles[tile], lit);
        frame.add(tile_work(part, tile), worker);
    });
}

void render_part(const FramePart& part, Stats& stats)
{
    Stopwatch watch;
    const bool fits = begin_part(part);
    stats.setup_ms += watch.lap_ms();
    if (!fits) {
        const int tile_pixels = part.pass.tile_size / part.pass.samples;
        for (const Region& half : halves(part.pixels, tile_pixels))
            render_part({part.frame, part.plan, part.pass, part.items, part.memory, half}, stats);
        return;
    }
    if (part.pass.shadows)
        render_tiles_in_shadow(part, stats);
    else
        render_tiles(part);
    stats.in_view += part.memory.view.in_view_count;
    stats.tile_entries += part.memory.view.entry_count;
}

/// Prepares every worker's tile memory, and the marks of holes.
void prepare(const FrameContext& frame, const PassPlan& pass, FrameMemory& memory)
{
    const std::size_t lights = frame.world.lights.size();
    while (int(memory.workers.size()) < frame.tasks.threads())
        memory.workers.push_back(std::make_unique<TileWorker>());
    for (const auto& worker : memory.workers) {
        resize(worker->items, pass.tile_size);
        resize(worker->shade, pass.tile_size, pass.color, pass.aovs);
        if (pass.packing) resize(worker->packed, pass.tile_size, lights);
        if (pass.shadows)
            worker->lit.resize(lights * std::size_t(pass.tile_size) * std::size_t(pass.tile_size));
    }
    const Region& region = frame.view.region;
    if (pass.fill)
        memory.holes.pixel.resize(std::size_t(region.width) * std::size_t(region.height));
}

/// Moves the workers' times and counts to the statistics.
void collect(FrameMemory& memory, int threads, Stats& stats)
{
    for (const auto& worker : memory.workers) {
        stats.raster_ms += worker->raster_ms / threads;
        stats.resolve_ms += worker->resolve_ms / threads;
        stats.shadow_ms += worker->shadow_ms / threads;
        stats.shade_ms += worker->shade_ms / threads;
        stats.uncertain_lanes += worker->counts.uncertain;
        stats.ambiguous_lanes += worker->counts.ambiguous;
        stats.exact_calls += worker->counts.effort.exact_calls;
        stats.hits += worker->hit_count;
        stats.missed += worker->missed_count;
        worker->raster_ms = worker->resolve_ms = worker->shadow_ms = worker->shade_ms = 0;
        worker->counts = {};
        worker->hit_count = worker->missed_count = 0;
    }
    add_light_visibility_stats(memory.lit, stats);
}

} // namespace

void render_frame(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources)
{
    const Region& all = frame.view.region;
    const std::size_t lights = frame.world.lights.size();
    ItemSource& items = sources.items ? *sources.items : memory.raster;
    memory.lit.map_maker = sources.maps;
    const FramePlan plan(settings, lights, &items == &memory.raster); // ours have no holes
    resize(frame.film, all, {settings.color, settings.aovs, lights});
    Stats given_up; // of a frame that was cancelled
    collect(memory, 1, given_up);
    frame.begin(plan.work(all));
    for (const PassPlan& pass : plan.passes()) {
        prepare(frame, pass, memory);
        const int side = pass.part_side;
        for (int y = 0; y < all.height; y += side)
            for (int x = 0; x < all.width; x += side)
                render_part({frame, plan, pass, items, memory,
                                {all.x + x, all.y + y, std::min(side, all.width - x),
                                    std::min(side, all.height - y)}},
                    stats);
        if (!pass.fill) continue;
        Stopwatch watch;
        stats.interpolated += interpolate_holes(memory.holes, frame.tasks, frame.film);
        stats.shade_ms += watch.lap_ms();
    }
    collect(memory, frame.tasks.threads(), stats);
}

} // namespace firsthit
