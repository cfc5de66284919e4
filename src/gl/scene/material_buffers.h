// material_buffers.h - materials and textures where shaders read them.
#pragma once

#include "gl/scene/kept_copy.h"
#include "gl/device/objects.h"
#include "material/texels.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <vector>

namespace firsthit::gl {

/// Uploaded when something of them is new, which is found out by comparing with a copy. All texels
/// of all textures lie in one buffer of words:
///
///     (textures) where its levels are, how many, width and height of the first
///     (levels)   where its texels are
///     texels     Texture::texels(), two words each
class MaterialBuffers {
  public:
    /// throws  DeviceError: more texels than `max_storage_bytes` hold, or no memory
    void update(const Scene& scene, std::int64_t max_storage_bytes);

    /// As the textures of materials.glsl and sample_texture.glsl.
    void bind();

    /// The model of all materials (its place in material/models.h), or -1 where they have several.
    int only_model() const { return only_model_; }

    /// So far.
    std::uint64_t uploads() const { return uploads_; }
    std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    BufferTexture material_texels_, word_texels_;
    Buffer materials_;     // (materials) MaterialTexels
    Buffer texture_words_; // see above
    std::vector<MaterialTexels> material_;
    KeptCopy<MaterialTexels> kept_material_;
    std::vector<std::uint32_t> tables_;
    std::vector<std::uint32_t> words_; // copy of texture_words_
    int only_model_ = 0;
    std::uint64_t uploads_ = 0, uploaded_bytes_ = 0;
};

} // namespace firsthit::gl
