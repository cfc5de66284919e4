// sky_stage.h - the stage of a frame that finds which directions of the sky the hits see.
#pragma once

#include "shadow/exact/exact_shadows.h"
#include "shadow/sky/sky_rays.h"

#include <firsthit/stats.h>

namespace firsthit {

/// The memory of the stage, kept from frame to frame. Shadow tests use that of the exact shadows.
struct SkyMemory {
    SkyRays rays;
    std::vector<glm::dvec3> directions;
    int known = 0; // of how many directions these are
    glm::dvec3 known_zenith{0};
    Buffer<std::uint64_t> answer; // (tiles, blocks) of one direction
    Buffer<std::uint64_t> words;  // (tiles, blocks, directions) SkyVisibility::words
    std::size_t blocks = 0;       // of one tile
    ShadowEffort effort;          // since add_sky_stats
    double ms = 0;
};

/// Finds for all hits of the tiles which directions of the sky are open to them: those that the hits' surfaces
/// face and no triangle hides, exactly as the shadow of a directional light (exact/shadow_ray.h). The tiles may
/// be those of a picture or any others, as of additional samples.
///
/// sky        with directions
/// camera_up  see zenith_of
/// shadows    scratch memory
/// progress   receives a step for each direction
struct SkyWork {
    const SeenTiles& seen;
    const Sky& sky;
    const glm::dvec3& camera_up;
    StageProgress progress{};
};
void find_sky_visibility(
    const SkyWork& work, ShadowMemory& shadows, SkyMemory& memory, Tasks& tasks);

/// That of one tile's samples, in SkyMemory.
SkyVisibility sky_visibility_of_tile(const SkyMemory& memory, std::size_t tile);

/// Adds the work since the last call to `stats`.
void add_sky_stats(SkyMemory& memory, Stats& stats);

} // namespace firsthit
