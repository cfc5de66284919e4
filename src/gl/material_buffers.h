// material_buffers.h - materials and textures where shaders read them.
#pragma once

#include "gl/objects.h"

#include <firsthit/scene.h>

namespace firsthit::gl {

/// Of one scene, uploaded once. All texels of all textures lie in one buffer of words:
///
///     linear light of the 256 sRGB codes, floats
///     (textures) where its levels' rows are, how many
///     (levels)   where its texels are, width (0: cannot be sampled, white), height
///     texels     RGBA, row by row
class MaterialBuffers {
  public:
    /// throws  DeviceError: more texels than `max_storage_bytes` hold, or no memory
    void upload(const Scene& scene, std::int64_t max_storage_bytes);

    /// As the storage blocks of materials.glsl and sample_texture.glsl.
    void bind() const;

    std::size_t bytes() const { return materials_.size() + texture_words_.size(); }

  private:
    Buffer materials_;     // (materials) MaterialData
    Buffer texture_words_; // see above
};

} // namespace firsthit::gl
