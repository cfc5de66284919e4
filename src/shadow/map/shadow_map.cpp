// shadow_map.cpp - shadow maps of all lights, made by the rasteriser and kept from frame to frame.
#include "shadow/map/shadow_map.h"

#include "shadow/map/cutout_depth.h"
#include "shadow/map/map_pencil.h"
#include "shadow/map/merge_faces.h"
#include "visibility/bin/bin_triangles.h"
#include "visibility/bin/project.h"

#include <algorithm>

namespace firsthit {
namespace {

constexpr int kTile = 64; // texels

/// A rectangle of a map's texels.
struct TexelRectangle {
    int x, y, width, height;
};

/// Rasterises a rectangle of the map. Splits it in halves if it is too large for the rasteriser or
/// covers too many triangles.
void raster_rectangle(const World& world, const TexelRectangle& rectangle, ShadowMaps& maps,
    ShadowMap& map, Tasks& tasks)
{
    ViewMemory& view = maps.view;
    const int longest = std::max(rectangle.width, rectangle.height);
    bool fits = longest <= kMaxPencil;
    if (fits) {
        Pencil pencil = view.pencil;
        pencil.width = rectangle.width;
        pencil.height = rectangle.height;
        pencil.x0 = rectangle.x + 0.5 - 0.5 * map.width();
        pencil.y0 = rectangle.y + 0.5 - 0.5 * map.height();
        lay_out(pencil, kTile, view);
        take_triangles(*world.scene, view, kShadowOpacity);
        project_vertices(world.position, pencil, view, tasks, CornerSpace::flat);
        fits = bin_triangles(view, view, view, tasks, TinyTriangles::depths);
    }
    if (!fits) {
        const bool wide = rectangle.width >= rectangle.height;
        const int cut = (longest / kTile + 1) / 2 * kTile;
        const TexelRectangle first{
            rectangle.x, rectangle.y, wide ? cut : rectangle.width, wide ? rectangle.height : cut};
        const TexelRectangle second{wide ? rectangle.x + cut : rectangle.x,
            wide ? rectangle.y : rectangle.y + cut, wide ? rectangle.width - cut : rectangle.width,
            wide ? rectangle.height : rectangle.height - cut};
        for (const TexelRectangle& half : {first, second})
            raster_rectangle(world, half, maps, map, tasks);
        return;
    }
    tasks.for_each(std::size_t(view.tiles()), [&](std::size_t tile, std::size_t worker) {
        DepthTile& depth = maps.workers[worker]->tile;
        raster_depth(view, view.rays(int(tile)), depth_bin_of(view, tile), depth);
        if (view.cutouts.any())
            raster_cutout_depth(
                view, view.pencil.parallel, view.rays(int(tile)), entries_of(view, tile), depth);
        const int x = view.first_x(int(tile)), y = view.first_y(int(tile));
        store_depth(depth, view.pencil,
            {.depth = &map.depth[quad_offset(rectangle.x + x, rectangle.y + y, map.width())],
                .quads_x = quads(map.width()),
                .farthest =
                    &map.farthest.at((rectangle.x + x) / kCellSide, (rectangle.y + y) / kCellSide),
                .cells_x = map.farthest.across,
                .width = std::min(kTile, rectangle.width - x),
                .height = std::min(kTile, rectangle.height - y)});
    });
}

/// Whether the world has cut-outs.
bool find_cutouts(const World& world, ShadowMaps& maps)
{
    maps.view.cutouts.find(*world.scene, kShadowOpacity);
    return maps.view.cutouts.any();
}

void make_map(const World& world, int face, ShadowMaps& maps, ShadowMap& map, Tasks& tasks)
{
    const Pencil pencil = set_map_transform(world, face, map);
    const std::size_t texels =
        std::size_t(quads(map.width())) * std::size_t(quads(map.height())) * kQuadTexels;
    map.depth.resize(texels, texels / 2); // spare: the bounds of hits change from frame to frame
    map.farthest.resize(map.width(), map.height());
    maps.view.pencil = pencil;
    raster_rectangle(world, {0, 0, map.width(), map.height()}, maps, map, tasks);
}

} // namespace

void start_maps(const World& world, int threads, ShadowMaps& maps)
{
    if (!maps.complete) maps.light.clear();
    maps.light.resize(world.lights.size());
    for (std::size_t light = 0; light < maps.light.size(); ++light)
        maps.light[light].frame = light_frame(world.lights[light]);
    while (int(maps.workers.size()) < threads) {
        maps.workers.push_back(std::make_unique<ShadowMaps::Worker>());
        resize(maps.workers.back()->tile, kTile);
    }
    for (const auto& worker : maps.workers)
        worker->bounds.assign(world.lights.size(), LightBounds{});
}

void add_hits(const HitTile& hits, ShadowMaps& maps, std::size_t worker)
{
    for (std::size_t light = 0; light < maps.light.size(); ++light)
        add_hits(hits, light, maps, worker);
}

void add_hits(const HitTile& hits, std::size_t light, ShadowMaps& maps, std::size_t worker)
{
    add_hits(hits, maps.light[light].frame, maps.workers[worker]->bounds[light]);
}

void plan_maps(const World& world, const ShadowOptions& options, std::span<LightBounds> bounds,
    ShadowMaps& maps, Tasks& tasks)
{
    if (!maps.complete) maps.light.clear();
    maps.complete = false;
    maps.filter = options.shadow_filter;
    maps.bias = options.shadow_bias;
    maps.texels = 0;
    maps.changed.clear();
    maps.light.resize(world.lights.size());
    if (maps.light.empty()) return;
    const auto wanted = [&](std::size_t number, int face) {
        return MapSource{maps.light[number].frame,
            map_fit(
                bounds[number][std::size_t(face)], options.shadow_map_size, options.shadow_filter),
            maps.geometry.version};
    };
    const auto for_maps = [&](const auto& f) {
        for (std::size_t number = 0; number < maps.light.size(); ++number)
            for (int face = 0; face < kFaces; ++face)
                f(MapNumber{number, face}, wanted(number, face));
    };
    for (std::size_t number = 0; number < maps.light.size(); ++number) {
        maps.light[number].frame = light_frame(world.lights[number]);
        merge_faces(bounds[number]);
    }
    // If no map can be kept, the geometry need not be compared.
    bool remake_all = true;
    for_maps([&](const MapNumber& k, const MapSource& source) {
        if (source.fit.width > 0 && source == map_of(maps, k).source) remake_all = false;
    });
    update_copy(world, remake_all, maps.geometry, tasks);
    // Where cut-outs are there follows from materials and textures, which are not compared.
    const bool cutouts = find_cutouts(world, maps);
    if (cutouts || maps.had_cutouts) ++maps.geometry.version;
    maps.had_cutouts = cutouts;
    for_maps([&](const MapNumber& k, const MapSource& source) {
        maps.texels += std::uint64_t(source.fit.width) * std::uint64_t(source.fit.height);
        ShadowMap& map = map_of(maps, k);
        if (source == map.source) return;
        map.source = source;
        if (source.fit.width > 0) maps.changed.push_back(k);
    });
}

void update_maps(const World& world, const ShadowOptions& options, ShadowMaps& maps, Tasks& tasks,
    const MapMaking& making)
{
    maps.bounds.assign(world.lights.size(), LightBounds{});
    for (const auto& worker : maps.workers)
        for (std::size_t light = 0; light < maps.bounds.size(); ++light)
            for (std::size_t face = 0; face < kFaces; ++face)
                maps.bounds[light][face].add(worker->bounds[light][face]);
    plan_maps(world, options, maps.bounds, maps, tasks);
    const std::size_t count = maps.changed.size();
    if (making.maker) making.maker->make(world, maps, tasks);
    for (std::size_t k = 0; !making.maker && k < count; ++k) {
        const MapNumber& number = maps.changed[k];
        make_map(world, number.face, maps, map_of(maps, number), tasks);
        if (k + 1 < count) making.progress.step(k, count);
    }
    maps.updates += maps.changed.size();
    maps.complete = true;
    if (making.maker || count == 0)
        making.progress.step(0, 1);
    else
        making.progress.step(count - 1, count);
}

} // namespace firsthit
