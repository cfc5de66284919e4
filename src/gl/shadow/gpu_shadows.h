// gpu_shadows.h - the shadow maps of the gpu engine, kept from frame to frame.
#pragma once

#include "base/tasks.h"
#include "gl/shadow/depth_pass.h"
#include "gl/scene/light_tables.h"
#include "gl/shadow/map_texels.h"
#include "gl/scene/scene_buffers.h"

#include <firsthit/options/shadow_options.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// The lights and shadow maps on OpenGL. A section of a picture calls, in turn:
///
///     set_lights(...)      uploads the lights, which the pass that finds the bounds of hits needs
///     update_maps(...)     or use_maps(...)
class GpuShadows {
  public:
    /// Uploads and binds the lights, without maps.
    void set_lights(const World& world, const Rays& rays);

    /// What the maps depend on.
    struct Wanted {
        const World& world;
        const ShadowOptions& options;
        const SceneBuffers& scene;
        const Rays& rays;
        std::span<LightBounds> bounds; // (lights) bounds of the visible hits
    };

    /// Draws the maps whose source has changed (see shadow/map/shadow_map.h).
    /// throws  DeviceError: no memory, or a map beyond the driver's limits
    void update_maps(const Wanted& wanted, std::int64_t max_storage_bytes, Tasks& tasks);

    /// Uploads maps that the cpu engine made.
    void use_maps(const World& world, const ShadowMaps& maps, const Rays& rays,
        std::int64_t max_storage_bytes);

    /// Number of maps drawn so far.
    std::uint64_t updates() const { return updates_; }

    /// The maps of the world's lights, without depths, which stay on OpenGL.
    std::span<const ShadowLight> maps() const { return maps_.light; }
    const MapTexels& texels() const { return texels_; }

  private:
    void upload_tables(
        const World& world, const Rays& rays, std::span<const ShadowLight> maps, int filter);

    ShadowMaps maps_; // sources and matrices
    MapTexels texels_;
    DepthPass depth_pass_;
    std::vector<LightData> light_data_;
    std::vector<MapData> map_data_;
    gl::Buffer lights_, map_table_;
    std::uint64_t updates_ = 0;
};

} // namespace firsthit::gl
