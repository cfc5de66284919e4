// gpu_shadows.cpp - the shadow maps of the gpu engine, kept from frame to frame.
#include "gl/shadow/gpu_shadows.h"

#include "gl/bindings.h"
#include "gl/device/context.h"

#include <algorithm>
#include <span>

namespace firsthit::gl {
namespace {

/// Uploads a table. A uniform block must have its declared size, `room` bytes, even if fewer are
/// used.
void upload(Buffer& table, std::span<const std::byte> data, std::size_t room)
{
    table.resize(std::max(data.size(), room));
    table.upload(0, data.data(), data.size());
}

void bind_table(const Buffer& table, GLuint binding, std::size_t lights)
{
    if (lights <= kFewLights)
        glBindBufferBase(GL_UNIFORM_BUFFER, binding, table.name());
    else
        table.bind_storage(binding);
}

} // namespace

void GpuShadows::upload_tables(
    const World& world, const Rays& rays, std::span<const ShadowLight> maps, int filter)
{
    fill_lights(world, rays, maps, light_data_);
    fill_maps(maps, rays, texels_.first(), filter, map_data_);
    upload(lights_, std::as_bytes(std::span(light_data_)), kFewLights * sizeof(LightData));
    upload(map_table_, std::as_bytes(std::span(map_data_)), kFewLights * kFaces * sizeof(MapData));
    bind_table(lights_, kLightsBlock, light_data_.size());
    bind_table(map_table_, kMapsBlock, light_data_.size());
    if (!maps.empty()) texels_.bind_texels();
}

void GpuShadows::set_lights(const World& world, const Rays& rays)
{
    upload_tables(world, rays, {}, 1);
}

void GpuShadows::update_maps(const Wanted& wanted, std::int64_t max_storage_bytes, Tasks& tasks)
{
    plan_maps(wanted.world, wanted.options, wanted.bounds, maps_, tasks);
    texels_.lay_out(maps_.light, max_storage_bytes);
    depth_pass_.draw_changed(wanted.world, wanted.scene, texels_, maps_);
    updates_ += maps_.changed.size();
    maps_.complete = true;
    upload_tables(wanted.world, wanted.rays, maps_.light, wanted.options.shadow_filter);
}

void GpuShadows::use_maps(
    const World& world, const ShadowMaps& maps, const Rays& rays, std::int64_t max_storage_bytes)
{
    maps_.complete = false; // what was drawn is lost
    texels_.lay_out(maps.light, max_storage_bytes);
    texels_.upload(maps.light);
    upload_tables(world, rays, maps.light, maps.filter);
}

} // namespace firsthit::gl
