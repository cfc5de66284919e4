// frame.cpp - the cpu engine: a picture from a posed world, tile by tile.
#include "cpu/frame.h"

#include "base/stopwatch.h"
#include "cpu/film_planes.h"
#include "film/film_size.h"
#include "visibility/raster/raster_tile.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace firsthit {
namespace {

/// One pass over the picture: which rays, and what is kept of them.
struct Pass {
    int samples = 1; // on a pixel's side
    bool color = true;
    std::span<const Aov> aovs;
    const Settings* shadows = nullptr; // how to find them; null: every light reaches everything
    const Packing* packing = nullptr;  // of the pixels whose rays are shot; null: all
    bool fill = false;                 // holes get the colours around them
};

/// Samples on the side of a part whose hits are kept for the lights: 100 MB, and 400 MB, so that
/// maps are seldom made for parts.
constexpr int kExactSide = 2048;
constexpr int kMapSide = 4096;

/// Samples on a tile's side: whole blocks and whole pixels.
int tile_samples(int tile_size, int samples)
{
    const int step = std::lcm(kBlock, samples);
    return std::min((tile_size + step - 1) / step * step, kMaxTile / step * step);
}

/// Puts the part's rays and tiles into the memory.
void lay_out(const View& view, const Region& part, int samples, int tile_size, ViewMemory& memory)
{
    memory.pencil = pencil_of(view, part, samples);
    memory.tile_size = tile_size;
    memory.tiles_x = (memory.pencil.width + tile_size - 1) / tile_size;
    memory.tiles_y = (memory.pencil.height + tile_size - 1) / tile_size;
    const int longest = std::max(memory.pencil.width, memory.pencil.height);
    memory.tile_of.resize(std::size_t(longest));
    for (int k = 0; k < longest; ++k) memory.tile_of[std::size_t(k)] = std::uint8_t(k / tile_size);
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

/// The picture's pixel that the tile's first sample is; one sample a pixel.
std::array<int, 2> first_pixel(const ViewMemory& view, const Region& part, int tile)
{
    return {part.x + tile % view.tiles_x * view.tile_size,
        part.y + tile / view.tiles_x * view.tile_size};
}

/// The tile's items and hits. Which triangle does each sample see, and where exactly?
HitTile see_tile(ItemSource& items, const Region& part, const Pass& pass, FrameMemory& memory,
    std::size_t tile, std::size_t place, std::size_t number)
{
    TileWorker& worker = *memory.workers[number];
    Stopwatch lap;
    const std::span<std::uint64_t> holes = memory.holes.of(place);
    std::fill(holes.begin(), holes.end(), 0);
    items.tile(memory.view, int(tile), worker.items, holes, number);
    if (pass.packing) {
        const auto [x, y] = first_pixel(memory.view, part, int(tile));
        worker.missed_count += keep_lattice(pass.packing->lattice(), x, y, worker.items, holes);
    } else {
        worker.missed_count += count_holes(holes);
    }
    worker.raster_ms += lap.lap_ms();
    const HitTile hits = resolve_tile(memory.view, worker.items, memory.hits.of(place));
    worker.resolve_ms += lap.lap_ms();
    worker.counts.uncertain += worker.items.counts.uncertain;
    worker.counts.ambiguous += worker.items.counts.ambiguous;
    worker.counts.effort.exact_calls += worker.items.counts.effort.exact_calls;
    worker.hit_count += count_hits(hits);
    return hits;
}

/// The tile's colours and planes, to the film.
void finish_tile(const World& world, const HitTile& hits, const LightVisibility& lit,
    const TilePlace& place, const Pass& pass, TileWorker& worker, Film& film)
{
    Stopwatch lap;
    const ShadeTargets& targets = worker.shade.targets;
    if (pass.packing) {
        const auto [x, y] = first_pixel(place.view, place.part, place.tile);
        pack(*pass.packing, x, y, hits, lit, world.lights.size(), worker.packed);
        shade_tile(worker.packed.hits, world, worker.packed.lit, targets);
        store_packed(worker.packed, place, targets, world.scene->background, film);
    } else if (hits.runs.empty() && pass.aovs.empty() && pass.samples == 1) {
        store_background(place, world.scene->background, film);
    } else {
        shade_tile(hits, world, lit, targets); // what colour is it?
        store_tile(place, hits, lit, targets, film);
    }
    worker.shade_ms += lap.lap_ms();
}

/// Calls body(tile, worker) for all tiles, as their items become ready.
template <class Body>
void for_ready_tiles(ItemSource& items, const ViewMemory& view, Tasks& tasks, const Body& body)
{
    const auto tiles = std::size_t(view.tiles());
    for (std::size_t done = 0; done < tiles;) {
        const std::size_t ready = items.wait(view);
        tasks.for_each(
            ready - done, [&](std::size_t k, std::size_t worker) { body(done + k, worker); });
        done = ready;
    }
}

/// Items, hits and colours of one part of the picture. Where shadows have to be found, all tiles'
/// hits are kept for the lights; else each tile is finished while it is in cache.
void render_part(const World& world, const View& view, const Region& part, const Pass& pass,
    int tile_size, ItemSource& items, FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    Stopwatch watch;
    lay_out(view, part, pass.samples, tile_size, memory.view);
    const bool seen = items.start(world, view, part, pass.samples, memory.view, tasks);
    stats.setup_ms += watch.lap_ms();
    if (!seen) {
        for (const Region& half : halves(part, tile_size / pass.samples))
            render_part(world, view, half, pass, tile_size, items, memory, tasks, film, stats);
        return;
    }
    const std::size_t tiles = std::size_t(memory.view.tiles());
    const std::size_t kept = pass.shadows ? tiles : std::size_t(tasks.threads());
    resize(memory.hits, tile_size, kept);
    memory.hits.misses = !pass.aovs.empty();
    memory.hits.items =
        memory.hits.misses || (pass.shadows && pass.shadows->shadows != Shadows::map);
    resize(memory.holes, tile_size, kept);
    const auto finish = [&](std::size_t tile, std::size_t place, const LightVisibility& lit,
                            const HitTile& hits, std::size_t number) {
        TilePlace where{memory.view, part, view.region, pass.samples, int(tile)};
        if (pass.fill) where.holes = memory.holes.of(place);
        finish_tile(world, hits, lit, where, pass, *memory.workers[number], film);
        if (pass.fill) mark_holes(where, film.width, memory.holes.pixel.span());
    };
    if (!pass.shadows) {
        for_ready_tiles(items, memory.view, tasks, [&](std::size_t tile, std::size_t number) {
            const HitTile hits = see_tile(items, part, pass, memory, tile, number, number);
            finish(tile, number, {}, hits, number);
        });
    } else {
        memory.tiles.resize(tiles);
        start_light_visibility(world, *pass.shadows, tiles, memory.lit, tasks);
        for_ready_tiles(items, memory.view, tasks, [&](std::size_t tile, std::size_t number) {
            memory.tiles[tile] = see_tile(items, part, pass, memory, tile, tile, number);
            add_light_visibility_hits(memory.tiles[tile], tile, memory.lit, number);
        });
        watch.lap_ms();
        find_light_visibility(world, *pass.shadows, view.camera.eye, memory.tiles, memory.lit,
            tasks); // which lights reach it?
        stats.shadow_ms += watch.lap_ms();
        tasks.for_each(tiles, [&](std::size_t tile, std::size_t number) {
            TileWorker& worker = *memory.workers[number];
            Stopwatch lap;
            const LightVisibility lit =
                light_visibility_of_tile(world, memory.tiles, tile, memory.lit, worker.lit);
            worker.shadow_ms += lap.lap_ms();
            finish(tile, tile, lit, memory.tiles[tile], number);
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
        if (pass.packing) resize(worker->packed, tile_size, world.lights.size());
        if (pass.shadows)
            worker->lit.resize(
                world.lights.size() * std::size_t(tile_size) * std::size_t(tile_size));
    }
    resize(film, view.region.width, view.region.height, pass.color, pass.aovs, world.lights.size());
    if (pass.fill)
        memory.holes.pixel.resize(std::size_t(view.region.width) * std::size_t(view.region.height));
}

void render_pass(const World& world, const View& view, const Pass& pass, int tile_size,
    ItemSource& items, FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats)
{
    const int tile = tile_samples(tile_size, pass.samples);
    prepare(pass, tile, world, view, memory, tasks, film);
    // Parts small enough for the boxes' and tiles' integers, in whole tiles.
    int side = std::min(kMaxPencil, 255 * tile);
    if (pass.shadows)
        side = std::min(side, pass.shadows->shadows == Shadows::map ? kMapSide : kExactSide);
    const int step = side / tile * tile / pass.samples;
    const Region& all = view.region;
    for (int y = 0; y < all.height; y += step) {
        for (int x = 0; x < all.width; x += step) {
            const Region part{all.x + x, all.y + y, std::min(step, all.width - x),
                std::min(step, all.height - y)};
            render_part(world, view, part, pass, tile, items, memory, tasks, film, stats);
        }
    }
    if (!pass.fill) return;
    Stopwatch watch;
    stats.interpolated += interpolate_holes(memory.holes, tasks, film);
    stats.shade_ms += watch.lap_ms();
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

void render_frame(const World& world, const View& view, const Settings& settings,
    FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats, const FrameSources& sources)
{
    ItemSource& items = sources.items ? *sources.items : memory.raster;
    memory.lit.map_maker = sources.maps;
    film.width = view.region.width;
    film.height = view.region.height;
    clear_unused(film, settings.color, settings.aovs);
    // Planes are of the ray through the pixel's centre, every pixel's: with several samples, or
    // not all pixels, they are a second pass.
    const bool together = settings.samples == 1 && settings.interleave == 1;
    std::optional<Packing> packing;
    if (settings.interleave > 1) packing.emplace(settings.interleave);
    const Packing* const shot = packing ? &*packing : nullptr;
    // Our own items have no holes.
    const bool fill = settings.color && settings.interpolate && (shot || &items != &memory.raster);
    const std::span<const Aov> aovs = settings.aovs;
    const bool shadows = settings.shadows != Shadows::none && !world.lights.empty();
    const bool lit = std::find(aovs.begin(), aovs.end(), Aov::lit) != aovs.end();
    const auto find_shadows = [&](bool wanted) { return shadows && wanted ? &settings : nullptr; };
    if (settings.color || together)
        render_pass(world, view,
            {settings.samples, settings.color, together ? aovs : std::span<const Aov>(),
                find_shadows(settings.color || lit), shot, fill},
            settings.tile_size, items, memory, tasks, film, stats);
    if (!together && !aovs.empty())
        render_pass(world, view, {1, false, aovs, find_shadows(lit)}, settings.tile_size, items,
            memory, tasks, film, stats);
    collect(memory, tasks.threads(), stats);
}

} // namespace firsthit
