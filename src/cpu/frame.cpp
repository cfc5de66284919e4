// frame.cpp - the frame of the cpu engine: renders a posed world tile by tile.
#include "cpu/frame.h"

#include "base/stopwatch.h"
#include "cpu/adaptive/adaptive_frame.h"
#include "cpu/adaptive/edge_finder.h"
#include "cpu/adaptive/pixel_marks.h"
#include "cpu/film_planes.h"
#include "cpu/tile_stages.h"
#include "film/film_size.h"
#include "film/spread_pixels.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace firsthit {
namespace {

/// Samples of marked tiles whose hits are kept at once, and as many of one tile.
constexpr std::size_t kMarkedSamples = std::size_t(1) << 22;

/// Finds the part's blocks and tiles that hold marked pixels. Returns whether the tiles are not too
/// many.
bool find_marked(const FramePart& part)
{
    FrameMemory& memory = part.memory;
    ViewMemory& view = memory.view;
    const int n = part.pass.samples;
    wanted_blocks(*part.pass.only, {part.pixels.x * n, part.pixels.y * n}, view, memory.wanted,
        memory.marked);
    view.wanted = &memory.wanted;
    return memory.marked.size() <= 1 ||
           memory.marked.size() * std::size_t(view.tile_size * view.tile_size) <= kMarkedSamples;
}

/// The tiles of a part that are rendered.
std::size_t tiles_of(const FramePart& part)
{
    return part.pass.only ? part.memory.marked.size() : std::size_t(part.memory.view.tiles());
}

/// Lays out the part's rays and tiles, starts its items and prepares the memory of its tiles.
/// returns  false if the part is too large
bool begin_part(const FramePart& part)
{
    const FrameContext& frame = part.frame;
    const PassPlan& pass = part.pass;
    FrameMemory& memory = part.memory;
    Pencil pencil = pencil_of(frame.view, part.pixels, pass.samples, frame.steps);
    reach_all(frame.world.position, pencil);
    lay_out(pencil, pass.tile_size, memory.view);
    if (pass.only && !find_marked(part)) return false;
    const std::size_t tiles = tiles_of(part);
    if (tiles == 0) return true;
    if (!part.items.start(frame.world, memory.view, frame.tasks)) return false;
    const std::size_t kept = pass.keeps_hits() ? tiles : std::size_t(frame.tasks.threads());
    resize(memory.hits, pass.tile_size, kept);
    resize(memory.holes, pass.tile_size, kept);
    memory.hits.items = pass.keeps_items;
    memory.hits.misses = pass.keeps_misses;
    if (pass.keeps_hits()) memory.tiles.resize(tiles);
    if (pass.shadows)
        start_light_visibility(frame.world, part.plan.shadows(), tiles, memory.lit, frame.tasks);
    else if (pass.sky)
        start_tile_occlusion(frame.world, tiles, memory.lit.tile_occlusion, frame.tasks);
    return true;
}

/// Divides the part between two rows or columns of tiles, across its longer side.
///
/// tile_pixels  pixels on a side of a tile
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

/// The work of one loop over a tile, as FramePlan::work counts it.
std::uint64_t tile_work(const FramePart& part, std::size_t tile)
{
    const PixelRect rect = pixels_of(
        {part.memory.view, part.pixels, part.frame.view.region, part.pass.samples, int(tile)});
    return part.pass.samples_of({0, 0, rect.width, rect.height});
}

/// The number in its part of the tile that is rendered as number k.
std::size_t tile_number(const FramePart& part, std::size_t k)
{
    return part.pass.only ? part.memory.marked[k] : k;
}

/// Calls body(tile, k, worker) for the tiles that are rendered, counted by k, as their items become
/// ready.
template <class Body>
void for_ready_tiles(const FramePart& part, const Body& body)
{
    const std::size_t tiles = tiles_of(part);
    for (std::size_t done = 0; done < tiles;) {
        const std::size_t ready = part.pass.only ? tiles : part.items.wait(part.memory.view);
        part.frame.tasks.for_each(ready - done, [&](std::size_t k, std::size_t worker) {
            const std::size_t tile = tile_number(part, done + k);
            body(tile, done + k, worker);
            part.frame.add(tile_work(part, tile), worker);
        });
        done = ready;
    }
}

/// Takes each tile from its items to its colours while it is in cache.
void render_tiles(const FramePart& part)
{
    for_ready_tiles(part, [&](std::size_t tile, std::size_t, std::size_t worker) {
        const TileTurn turn{tile, worker, worker};
        find_items(part, turn);
        shade_and_store(part, turn, find_hits(part, turn), {});
    });
}

/// Records a tile's hits for the stages between.
void add_hits(const FramePart& part, std::size_t tile, std::size_t worker)
{
    FrameMemory& memory = part.memory;
    if (part.pass.shadows)
        add_light_visibility_hits(memory.tiles[tile], tile, memory.lit, worker);
    else if (memory.lit.tile_occlusion.has_occluders())
        add_hits(memory.tiles[tile], tile, memory.lit.tile_occlusion);
}

/// Finds which directions of the sky the hits of all tiles see.
void find_sky(const FramePart& part)
{
    const FrameContext& frame = part.frame;
    const Camera& camera = frame.view.camera;
    TileOcclusion& occlusion = part.memory.lit.tile_occlusion;
    const SeenTiles seen{frame.world, camera.eye, part.memory.tiles,
        occlusion.has_occluders() ? &occlusion : nullptr};
    find_sky_visibility(
        {seen, part.plan.sky(), camera.up, {frame.progress, part.pass.samples_of(part.pixels)}},
        part.memory.lit.exact, part.memory.sky, frame.tasks);
}

/// Keeps the hits of all tiles until it is known which lights reach them, then shades the tiles.
void render_tiles_in_shadow(const FramePart& part, Stats& stats)
{
    const FrameContext& frame = part.frame;
    FrameMemory& memory = part.memory;
    for_ready_tiles(part, [&](std::size_t tile, std::size_t k, std::size_t worker) {
        const TileTurn turn{tile, k, worker};
        find_items(part, turn);
        memory.tiles[k] = find_hits(part, turn);
        add_hits(part, k, worker);
    });
    Stopwatch watch;
    if (part.pass.shadows)
        find_light_visibility(frame, memory.tiles, memory.lit, part.pass.samples_of(part.pixels));
    stats.shadow_ms += watch.lap_ms();
    if (part.pass.sky) find_sky(part);
    frame.tasks.for_each(memory.tiles.size(), [&](std::size_t k, std::size_t worker) {
        const std::size_t tile = tile_number(part, k);
        const TileTurn turn{tile, k, worker};
        const LightVisibility lit = light_visibility(part, turn);
        shade_and_store(part, turn, memory.tiles[k], lit);
        frame.add(tile_work(part, tile), worker);
    });
}

/// Renders a part of the picture, or its two halves if it is too large.
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
    if (tiles_of(part) == 0) return;
    if (part.pass.keeps_hits())
        render_tiles_in_shadow(part, stats);
    else
        render_tiles(part);
    stats.in_view += part.memory.view.in_view_count;
    stats.tile_entries += part.memory.view.entry_count;
    if (part.pass.edges) part.pass.edges->find_touched(part.pixels, part.memory.view);
}

/// Prepares the memory of every worker, and the mask of holes.
void prepare(const FrameContext& frame, const PassPlan& pass, FrameMemory& memory)
{
    const std::size_t lights = frame.world.lights.size();
    while (int(memory.workers.size()) < frame.tasks.threads())
        memory.workers.push_back(std::make_unique<TileWorker>());
    for (const auto& worker : memory.workers) {
        resize(worker->items, pass.tile_size);
        resize(worker->shade, pass.tile_size, pass.color, pass.aovs);
        if (pass.only)
            worker->wanted.resize(
                std::size_t(pass.tile_size) * std::size_t(pass.tile_size) / kBlockSamples);
        if (pass.shadows)
            worker->lit.resize(lights * std::size_t(pass.tile_size) * std::size_t(pass.tile_size));
    }
    const Region& region = frame.view.region;
    if (pass.fill)
        memory.holes.pixel.resize(std::size_t(region.width) * std::size_t(region.height));
}

/// Adds the workers' times and counts to the statistics and sets them to 0.
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
    add_sky_stats(memory.sky, stats);
}

/// A pass of a frame.
struct FramePass {
    const FramePlan& plan;
    const PassPlan& pass;
    ItemSource& items;
    FrameMemory& memory;
};

/// Renders the frame's region part by part, and fills holes.
void render_pass(const FrameContext& frame, const FramePass& of, Stats& stats)
{
    const Region& all = frame.view.region;
    const PassPlan& pass = of.pass;
    prepare(frame, pass, of.memory);
    const int side = pass.part_side;
    for (int y = 0; y < all.height; y += side)
        for (int x = 0; x < all.width; x += side)
            render_part({frame, of.plan, pass, of.items, of.memory,
                            {all.x + x, all.y + y, std::min(side, all.width - x),
                                std::min(side, all.height - y)}},
                stats);
    if (pass.edges) pass.edges->find_neighbours(of.memory.view);
    if (!pass.fill) return;
    Stopwatch watch;
    stats.interpolated += interpolate_holes(of.memory.holes, frame.tasks, frame.film);
    stats.shade_ms += watch.lap_ms();
}

/// Renders the shot pixels as a picture of their own, and makes the colours of the frame's film from it.
/// spread  whether pixels that are not shot get the colours around them; otherwise they are background
void render_shot(const FrameContext& frame, const FramePass& of, bool spread, Stats& stats)
{
    constexpr std::size_t kRows = 16; // rows of a task
    const Region& all = frame.view.region;
    const PixelSteps& steps = of.pass.steps;
    View view = frame.view;
    view.region = steps.shot(all);
    std::vector<float>& color = frame.film.color.value;
    const glm::vec3& background = frame.world.scene->background;
    const bool none = view.region.width <= 0 || view.region.height <= 0;
    if (!spread || none)
        for (std::size_t k = 0; k < color.size(); ++k) color[k] = background[int(k % 3)];
    if (none) return;
    Film& film = of.memory.shot;
    resize(film, view.region, {true, {}, 0});
    render_pass({frame.world, view, frame.tasks, film, frame.progress, steps}, of, stats);
    Stopwatch watch;
    const SpreadPicture picture{steps, all, film.color.value, color};
    std::atomic<std::uint64_t> made{0};
    frame.tasks.for_ranges(
        std::size_t(all.height), kRows, [&](std::size_t first, std::size_t last) {
            if (spread)
                made += spread_pixels(picture, int(first), int(last));
            else
                place_pixels(picture, int(first), int(last));
        });
    stats.interpolated += made;
    stats.shade_ms += watch.lap_ms();
}

} // namespace

void render_frame(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources)
{
    if (wants_edges(settings) && !sources.edges && !sources.only)
        render_adaptively(frame, settings, memory, stats, sources);
    else if (has_layers(frame.world, settings))
        render_layers(frame, settings, memory, stats, sources);
    else
        render_surfaces(frame, settings, memory, stats, sources);
}

void render_surfaces(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources)
{
    const Region& all = frame.view.region;
    const std::size_t lights = frame.world.lights.size();
    ItemSource& items = sources.items ? *sources.items : memory.raster;
    memory.lit.map_maker = sources.maps;
    // The rasteriser has no holes.
    const FramePlan plan(settings, lights, &items == &memory.raster, sources);
    if (!sources.only || settings.samples == 1)
        resize(frame.film, all, {settings.color, settings.aovs, lights});
    // Times and counts that a cancelled frame left behind do not count.
    Stats cancelled;
    collect(memory, 1, cancelled);
    frame.begin(plan.work(all));
    for (const PassPlan& pass : plan.passes()) {
        if (pass.steps.all())
            render_pass(frame, {plan, pass, items, memory}, stats);
        else
            render_shot(frame, {plan, pass, items, memory}, settings.interpolate, stats);
    }
    collect(memory, frame.tasks.threads(), stats);
}

} // namespace firsthit
