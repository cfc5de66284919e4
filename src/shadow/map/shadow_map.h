// shadow_map.h - shadow maps of all lights, made by the rasteriser and kept from frame to frame.
//
// A frame calls, in turn:
//
//     start_maps(world, tasks.threads(), maps)
//     add_hits(hits, maps, worker)                each tile, once what it sees is known
//     update_maps(world, options, maps, tasks)
//     sample_shadow_map(maps, world, hits, light, visibility)    each tile and light
//
// source  Williams 1978; Robert and Schoepke 2006, section 3.2: "the shadow map only needs to be
//         updated when the scene is subject to changes during the rendering"
#pragma once

#include "base/tasks.h"
#include "frame/frame_progress.h"
#include "hits/hit_tile.h"
#include "shadow/map/geometry_copy.h"
#include "shadow/map/map_fit.h"
#include "shadow/map/map_maker.h"
#include "shadow/map/store_depth.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/options/shadow_options.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace firsthit {

/// Everything that a map's texels depend on. Cache key: equal sources give identical maps.
struct MapSource {
    LightFrame frame;
    MapFit fit;
    std::uint64_t geometry = 0;

    bool operator==(const MapSource&) const = default;
};

/// The map of one face of a light.
struct ShadowMap {
    MapSource source;
    Buffer<float> depth; // along the face's z from `origin`; +inf: no triangle; see quad_offset
    FarthestDepths farthest;
    // matrix * (p - origin) + offset is (texel x, texel y, depth) of a point p in world space.
    // Unless the light is parallel, the first two are multiplied by the depth. Texel i covers [i, i
    // + 1).
    glm::dmat3 matrix{1};
    glm::dvec3 origin{0};
    glm::dvec3 offset{0};

    int width() const { return source.fit.width; }
    int height() const { return source.fit.height; }
    float at(int x, int y) const { return depth[quad_offset(x, y, width())]; }
};

struct ShadowLight {
    LightFrame frame;
    std::array<ShadowMap, kFaces> map; // width 0: no hit lies on the face
};

/// Names one face of one light of a world.
struct MapNumber {
    std::size_t light = 0;
    int face = 0;
};

/// The maps of all lights, and the memory that is needed to make them.
struct ShadowMaps {
    std::vector<ShadowLight> light; // (lights of the world)
    int filter = 1;                 // settings.shadow_filter
    double bias = -1;               // settings.shadow_bias

    std::uint64_t updates = 0; // number of maps made so far
    std::uint64_t texels = 0;  // of all maps in use

    std::vector<LightBounds> bounds; // (lights) bounds of the hits of all workers
    std::vector<MapNumber> changed;  // maps that have to be made
    bool complete = false;           // every map agrees with its source
    bool had_cutouts = false;        // in the last frame

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

/// Begins a frame: reads the lights of the world and forgets the hits of the last frame.
void start_maps(const World& world, int threads, ShadowMaps& maps);

/// Adds a tile's hits to the bounds that the maps of all lights have to cover. Calls with different
/// workers may run at the same time.
void add_hits(const HitTile& hits, ShadowMaps& maps, std::size_t worker);

/// The same for one light.
void add_hits(const HitTile& hits, std::size_t light, ShadowMaps& maps, std::size_t worker);

/// Who makes the maps, and who is told about progress.
struct MapMaking {
    MapMaker* maker = nullptr; // draws the maps; null: our rasteriser
    StageProgress progress;    // receives a step for each map that has to be made
};

/// Makes the maps whose source has changed. A source follows from the world's triangles and lights,
/// the hits, options.shadow_map_size and .shadow_filter. Maps of unchanged sources are kept. The
/// result does not depend on the number of threads or on earlier frames.
void update_maps(const World& world, const ShadowOptions& options, ShadowMaps& maps, Tasks& tasks,
    const MapMaking& making = {});

/// The first half of update_maps: sets the source of every map, and lists in maps.changed the maps
/// that have to be made from it. The caller makes them and then sets maps.complete.
/// bounds  (lights) bounds of the visible hits
void plan_maps(const World& world, const ShadowOptions& options, std::span<LightBounds> bounds,
    ShadowMaps& maps, Tasks& tasks);

} // namespace firsthit
