// shadow_map.h - depth as each light sees it, made by the rasteriser and kept from frame to frame.
//
// A frame calls, in turn:
//
//     start_maps(world, tasks.threads(), maps)
//     add_hits(hits, maps, worker)                each tile, once what it sees is known
//     update_maps(world, settings, maps, tasks)
//     sample_shadow_map(maps, world, hits, light, lit)      each tile and light: shadow/sample_shadow_map.h
//
// source  Williams 1978; Robert and Schoepke 2006, section 3.2: "the shadow map only needs to be
//         updated when the scene is subject to changes during the rendering"
#pragma once

#include "base/tasks.h"
#include "hits/hit_tile.h"
#include "shadow/map/geometry_copy.h"
#include "shadow/map/map_fit.h"
#include "shadow/map/map_maker.h"
#include "shadow/map/store_depth.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/render.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace firsthit {

/// What a map was made from: equal again, equal map.
struct MapSource {
    LightFrame frame;
    MapFit fit;
    std::uint64_t geometry = 0;

    bool operator==(const MapSource&) const = default;
};

/// One face of a light.
struct ShadowMap {
    MapSource source;
    Buffer<float> depth; // along the face's z from `origin`, +inf where nothing is; see quad_offset
    FarthestDepths farthest;
    // matrix * (p - origin) + offset: (texel x, texel y, depth) of p; the first two times the depth
    // unless the light is parallel. Texel i reaches from i to i + 1.
    glm::dmat3 matrix{1};
    glm::dvec3 origin{0};
    glm::dvec3 offset{0};

    int width() const { return source.fit.width; }
    int height() const { return source.fit.height; }
    float at(int x, int y) const { return depth[quad_offset(x, y, width())]; }
};

struct ShadowLight {
    LightFrame frame;
    std::array<ShadowMap, kFaces> map; // width 0: no hit is there
};

/// One face of one light of a world.
struct MapNumber {
    std::size_t light = 0;
    int face = 0;
};

/// The maps of all lights and the memory that making them takes.
struct ShadowMaps {
    std::vector<ShadowLight> light; // as the world's
    int filter = 1;                 // of the settings
    double bias = -1;

    std::uint64_t updates = 0; // maps made so far
    std::uint64_t texels = 0;  // of the maps in use

    std::vector<LightBounds> bounds; // (lights) of all workers' hits
    std::vector<MapNumber> changed;  // that are to be made
    bool complete = false;           // all maps are what their sources say

    GeometryCopy geometry;
    ViewMemory view;
    struct Worker {
        std::vector<LightBounds> bounds;
        DepthTile tile{};
    };
    std::vector<std::unique_ptr<Worker>> workers;
};

inline ShadowMap& map_of(ShadowMaps& maps, const MapNumber& number)
{
    return maps.light[number.light].map[std::size_t(number.face)];
}

/// Begins a frame: the lights where they are now, and no hits yet.
void start_maps(const World& world, int threads, ShadowMaps& maps);

/// Adds a tile's hits to what the maps have to show. Calls with different workers may overlap.
void add_hits(const HitTile& hits, ShadowMaps& maps, std::size_t worker);

/// The same for one light.
void add_hits(const HitTile& hits, std::size_t light, ShadowMaps& maps, std::size_t worker);

/// Makes the maps that are not what the world's triangles and lights, the hits and
/// settings.shadow_map_size and .shadow_filter ask for. A map stays where its light, the triangles
/// and its fit (map_fit.h) have not changed. Does not depend on threads or earlier frames.
/// maker  null: our rasteriser
void update_maps(const World& world, const Settings& settings, ShadowMaps& maps, Tasks& tasks,
    MapMaker* maker = nullptr);

/// The first half of that: gives every map its source, and lists in maps.changed those that are not
/// what it says. Who has made them sets maps.complete.
/// bounds  (lights) of the visible hits
void plan_maps(const World& world, const Settings& settings, std::span<LightBounds> bounds,
    ShadowMaps& maps, Tasks& tasks);

} // namespace firsthit
