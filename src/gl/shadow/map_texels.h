// map_texels.h - the texels of all shadow maps, in one buffer.
#pragma once

#include "gl/device/objects.h"
#include "shadow/map/shadow_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// The depths of all maps on OpenGL, each in the layout of ShadowMap::depth. A map stays at its
/// position as long as its reserved room is enough. Otherwise all maps get new positions with room
/// to grow, and their texels are moved.
class MapTexels {
  public:
    /// Reserves room for the maps of all faces.
    /// throws  DeviceError: more than `max_storage_bytes`, or no memory
    void lay_out(std::span<const ShadowLight> lights, std::int64_t max_storage_bytes);

    /// Uploads maps that the CPU made. lay_out() must have been called for them.
    void upload(std::span<const ShadowLight> lights);

    /// Copies the texels of a face to host memory. Waits for OpenGL.
    void read(std::size_t light, std::size_t face, ShadowMap& map) const;

    /// (lights, kFaces) index of the first texel of each face.
    std::span<const std::uint32_t> first() const { return first_; }

    /// Binds the texels as a storage block, for shaders that write them.
    void bind_storage(GLuint binding) const { texels_.bind_storage(binding); }
    /// Binds the texels as a buffer texture, for shaders that sample them.
    void bind_texels();

  private:
    Buffer texels_; // float
    BufferTexture sampled_;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> room_; // (lights, kFaces) reserved texels
};

} // namespace firsthit::gl
