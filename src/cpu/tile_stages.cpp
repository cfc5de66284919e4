// tile_stages.cpp - the stages of a frame of the cpu engine that work on one tile.
#include "cpu/tile_stages.h"

#include "base/stopwatch.h"
#include "cpu/adaptive/edge_finder.h"
#include "cpu/adaptive/pixel_marks.h"
#include "cpu/film_planes.h"
#include "shade/shade_environment.h"

#include <algorithm>

namespace firsthit {
namespace {

TilePlace place_of(const FramePart& part, const TileTurn& turn)
{
    TilePlace place{
        part.memory.view, part.pixels, part.frame.view.region, part.pass.samples, int(turn.tile)};
    if (part.pass.fill) place.holes = part.memory.holes.of(turn.place);
    place.only = part.pass.only;
    return place;
}

/// Asks for the items of the tile's samples that lie in marked pixels.
void want_marked(const FramePart& part, std::size_t tile, TileWorker& worker)
{
    const ViewMemory& view = part.memory.view;
    const int n = part.pass.samples;
    wanted_samples(*part.pass.only,
        {part.pixels.x * n + view.first_x(int(tile)), part.pixels.y * n + view.first_y(int(tile))},
        view.tile_size, worker.wanted.span());
    worker.items.wanted = worker.wanted.span();
}

} // namespace

void find_items(const FramePart& part, const TileTurn& turn)
{
    TileWorker& worker = *part.memory.workers[turn.worker];
    Stopwatch lap;
    const std::span<std::uint64_t> holes = part.memory.holes.of(turn.place);
    std::fill(holes.begin(), holes.end(), 0);
    worker.items.wanted = {};
    if (part.pass.only) want_marked(part, turn.tile, worker);
    part.items.tile(part.memory.view, int(turn.tile), worker.items, holes, turn.worker);
    worker.missed_count += count_holes(holes);
    worker.raster_ms += lap.lap_ms();
    worker.counts.uncertain += worker.items.counts.uncertain;
    worker.counts.ambiguous += worker.items.counts.ambiguous;
    worker.counts.effort.exact_calls += worker.items.counts.effort.exact_calls;
}

HitTile find_hits(const FramePart& part, const TileTurn& turn)
{
    const ViewMemory& view = part.memory.view;
    TileWorker& worker = *part.memory.workers[turn.worker];
    Stopwatch lap;
    HitTile hits = resolve_tile(view, view.pencil, worker.items, part.memory.hits.of(turn.place));
    hits.pixel = 1.0f / glm::vec2(part.pass.steps.x, part.pass.steps.y);
    worker.resolve_ms += lap.lap_ms();
    worker.hit_count += count_hits(hits);
    return hits;
}

LightVisibility light_visibility(const FramePart& part, const TileTurn& turn)
{
    FrameMemory& memory = part.memory;
    TileWorker& worker = *memory.workers[turn.worker];
    Stopwatch lap;
    LightVisibility lit;
    if (part.pass.shadows)
        lit = light_visibility_of_tile(
            part.frame.world, memory.tiles, turn.place, memory.lit, worker.lit);
    if (part.pass.sky) lit.sky = sky_visibility_of_tile(memory.sky, turn.place);
    worker.shadow_ms += lap.lap_ms();
    return lit;
}

void shade_and_store(
    const FramePart& part, const TileTurn& turn, const HitTile& hits, const LightVisibility& lit)
{
    const World& world = part.frame.world;
    const PassPlan& pass = part.pass;
    Film& film = part.frame.film;
    TileWorker& worker = *part.memory.workers[turn.worker];
    const TilePlace place = place_of(part, turn);
    Stopwatch lap;
    const ShadeTargets& targets = worker.shade.targets;
    if (hits.runs.empty() && pass.aovs.empty() && pass.samples == 1 &&
        !shows_environment(*world.scene)) {
        store_background(place, world.scene->background, film);
    } else {
        shade_tile(hits, world, lit, targets);
        store_tile(place, hits, lit, targets, film);
    }
    if (pass.edges) pass.edges->record(pixels_of(place), hits, lit, turn.worker);
    if (pass.fill) mark_holes(place, film.width, part.memory.holes.pixel.span());
    worker.shade_ms += lap.lap_ms();
}

} // namespace firsthit
