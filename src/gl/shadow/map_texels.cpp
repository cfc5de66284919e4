// map_texels.cpp - the texels of all shadow maps, in one buffer.
#include "gl/shadow/map_texels.h"

#include "gl/bindings.h"
#include "gl/device/context.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firsthit::gl {
namespace {

/// The number of texels that a map takes in memory: quads at its edges are stored whole.
std::size_t stored_texels(const ShadowMap& map)
{
    return std::size_t(quads(map.width())) * std::size_t(quads(map.height())) * kQuadTexels;
}

} // namespace

void MapTexels::lay_out(std::span<const ShadowLight> lights, std::int64_t max_storage_bytes)
{
    const std::size_t faces = lights.size() * kFaces;
    std::size_t needed = 0;
    bool enough = faces == first_.size();
    for (std::size_t k = 0; k < faces; ++k) {
        const std::size_t texels = stored_texels(lights[k / kFaces].map[k % kFaces]);
        needed += texels;
        enough = enough && texels <= room_[k];
    }
    const std::size_t most = std::size_t(max_storage_bytes) / 4;
    if (needed > most)
        throw DeviceError(fmt::format("OpenGL: the shadow maps take {} bytes, one buffer may have "
                                      "{} ({}); smaller maps take less",
            needed * 4, max_storage_bytes, driver_name()));
    if (enough) return;

    // The size of maps changes from frame to frame: reserve half as much again.
    const bool spare = needed + needed / 2 + kQuadTexels * faces <= most;
    std::vector<std::uint32_t> first(faces), room(faces);
    std::size_t next = 0;
    for (std::size_t k = 0; k < faces; ++k) {
        const std::size_t texels = stored_texels(lights[k / kFaces].map[k % kFaces]);
        first[k] = std::uint32_t(next);
        room[k] = std::uint32_t(texels + (spare ? texels / 2 : 0));
        next += room[k];
    }
    Buffer texels;
    texels.resize(next * 4);
    for (std::size_t k = 0; k < std::min(faces, first_.size()); ++k)
        if (const std::uint32_t kept = std::min(room_[k], room[k]))
            glCopyNamedBufferSubData(texels_.name(), texels.name(), GLintptr(first_[k]) * 4,
                GLintptr(first[k]) * 4, GLsizeiptr(kept) * 4);
    texels_ = std::move(texels);
    first_ = std::move(first);
    room_ = std::move(room);
    check("making room for shadow maps");
}

void MapTexels::upload(std::span<const ShadowLight> lights)
{
    for (std::size_t k = 0; k < lights.size() * kFaces; ++k) {
        const ShadowMap& map = lights[k / kFaces].map[k % kFaces];
        if (map.width() > 0)
            texels_.upload(std::size_t(first_[k]) * 4, map.depth.data(), stored_texels(map) * 4);
    }
}

void MapTexels::bind_texels()
{
    sampled_.look_at(texels_, GL_R32F, 4);
    sampled_.bind(kMapDepthUnit);
}

void MapTexels::read(std::size_t light, std::size_t face, ShadowMap& map) const
{
    const std::size_t texels = stored_texels(map);
    map.depth.resize(texels, texels / 2);
    glGetNamedBufferSubData(texels_.name(), GLintptr(first_[light * kFaces + face]) * 4,
        GLsizeiptr(texels * 4), map.depth.data());
}

} // namespace firsthit::gl
