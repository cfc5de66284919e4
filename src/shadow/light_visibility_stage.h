// light_visibility_stage.h - the stage of a frame that finds which lights reach the hits, by the
// technique that the settings ask for.
#pragma once

#include "frame/frame_context.h"
#include "hits/hit_tile.h"
#include "hits/light_visibility.h"
#include "shadow/exact/exact_shadows.h"
#include "shadow/map/shadow_map.h"
#include "shadow/exact/tile_occlusion.h"

#include <firsthit/options/shadow_options.h>
#include <firsthit/stats.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// The memory of the stage, kept from frame to frame.
struct LightVisibilityMemory {
    Shadows technique = Shadows::exact; // never none
    ShadowOptions options;              // options of maps
    bool by_occluders = true; // look for tiles behind occluders first; false: make complete maps
    TileOcclusion tile_occlusion;
    std::vector<std::uint8_t> dark; // (lights) 1: reaches no hit; used by maps
    ShadowMemory exact;
    LightVisibilityBits bits; // result of the exact technique
    ShadowMaps maps;
    MapMaker* map_maker = nullptr; // null: our rasteriser
};

/// Begins a section of the picture.
void start_light_visibility(const World& world, const ShadowOptions& options, std::size_t tiles,
    LightVisibilityMemory& memory, Tasks& tasks);

/// Records a tile's hits while they are in cache. Calls with different workers may run at the same
/// time.
void add_light_visibility_hits(
    const HitTile& hits, std::size_t tile, LightVisibilityMemory& memory, std::size_t worker);

/// Finds the exact shadows, or makes the shadow maps. To be called when the hits of all tiles are
/// known.
/// tiles  see test_exact_shadows
/// work   the work of this stage, in units of the frame's progress
void find_light_visibility(const FrameContext& frame, std::span<const HitTile> tiles,
    LightVisibilityMemory& memory, std::uint64_t work);

/// The light visibility of a tile's samples. The result points into `room`.
LightVisibility light_visibility_of_tile(const World& world, std::span<const HitTile> tiles,
    std::size_t tile, const LightVisibilityMemory& memory, Buffer<float>& room);

/// Adds the work since the last call to `stats`.
void add_light_visibility_stats(LightVisibilityMemory& memory, Stats& stats);

} // namespace firsthit
