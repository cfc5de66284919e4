// gpu_shadows.cpp - the shadow maps of the gpu engine, kept from frame to frame.
#include "gl/gpu_shadows.h"

#include "gl/bindings.h"
#include "gl/context.h"

namespace firsthit::gl {

void GpuShadows::upload_tables(
    const World& world, const SampleFrame& frame, std::span<const ShadowLight> maps, int filter)
{
    fill_lights(world, frame, maps, light_data_);
    fill_maps(maps, frame, texels_.first(), filter, map_data_);
    lights_.assign(std::span<const LightData>(light_data_));
    map_table_.assign(std::span<const MapData>(map_data_));
    lights_.bind_storage(kLights);
    map_table_.bind_storage(kMaps);
    if (!maps.empty()) texels_.bind(kMapDepth);
}

void GpuShadows::set_lights(const World& world, const SampleFrame& frame)
{
    upload_tables(world, frame, {}, 1);
}

void GpuShadows::update_maps(const World& world, const Settings& settings,
    const SceneBuffers& scene, const SampleFrame& frame, std::span<LightBounds> bounds,
    std::int64_t max_storage_bytes, Tasks& tasks)
{
    plan_maps(world, settings, bounds, maps_, tasks);
    texels_.lay_out(maps_.light, max_storage_bytes);
    depth_pass_.draw_changed(world, scene, texels_, maps_);
    updates_ += maps_.changed.size();
    maps_.complete = true;
    upload_tables(world, frame, maps_.light, settings.shadow_filter);
}

void GpuShadows::use_maps(const World& world, const ShadowMaps& maps, const SampleFrame& frame,
    std::int64_t max_storage_bytes)
{
    maps_.complete = false; // what was drawn is lost
    texels_.lay_out(maps.light, max_storage_bytes);
    texels_.upload(maps.light);
    upload_tables(world, frame, maps.light, maps.filter);
}

} // namespace firsthit::gl
