// map_texels.h - the texels of all shadow maps, in one buffer.
#pragma once

#include "gl/device/objects.h"
#include "shadow/map/shadow_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// Depths as ShadowMap::depth has them, in its order of quads, each face at its own place. A face
/// stays where it is while its room is enough; else all are given new places, with room to grow,
/// and what they hold goes along.
class MapTexels {
  public:
    /// Makes room for the texels of all faces' fits.
    /// throws  DeviceError: more than `max_storage_bytes`, or no memory
    void lay_out(std::span<const ShadowLight> lights, std::int64_t max_storage_bytes);

    /// Copies maps that the cpu made; after lay_out.
    void upload(std::span<const ShadowLight> lights);

    /// Copies a face's texels to the cpu; waits for it.
    void read(std::size_t light, std::size_t face, ShadowMap& map) const;

    /// (lights, kFaces) where each face's texels begin.
    std::span<const std::uint32_t> first() const { return first_; }

    /// For shaders that write them: as a storage block.
    void bind_storage(GLuint binding) const { texels_.bind_storage(binding); }
    /// For shaders that look them up.
    void bind_texels();

  private:
    Buffer texels_; // float
    BufferTexture look_up_;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> room_; // texels from there on
};

} // namespace firsthit::gl
