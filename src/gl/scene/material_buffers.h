// material_buffers.h - uploads materials and textures for shaders.
#pragma once

#include "gl/scene/kept_copy.h"
#include "gl/device/objects.h"
#include "material/texels.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <vector>

namespace firsthit::gl {

/// Materials and textures on OpenGL. They are uploaded again if they differ from a copy of the last
/// upload. All textures share one buffer of 32-bit words:
///
///     (textures, 4)  index of its first word in the table of levels; the number of levels, plus 2^8
///                    times the Wrap along u, plus 2^12 times that along v, plus 2^16 if it is
///                    sampled nearest; width; height
///     (levels)       index of the first word of its texels
///     texels         Texture::texels(), two words for each
class MaterialBuffers {
  public:
    /// Uploads what has changed.
    /// throws  DeviceError: the texels take more than `max_storage_bytes`, or no memory
    void update(const Scene& scene, std::int64_t max_storage_bytes);

    /// Binds the buffers as the textures of materials.glsl and sample_texture.glsl.
    void bind();

    /// The number of the only model (material/models.h); -1 if the materials have several models.
    int only_model() const { return only_model_; }

    /// Number of uploads and uploaded bytes so far.
    std::uint64_t uploads() const { return uploads_; }
    std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    BufferTexture material_texels_, word_texels_;
    Buffer materials_;     // (materials) MaterialTexels
    Buffer texture_words_; // the words described above
    std::vector<MaterialTexels> material_;
    KeptCopy<MaterialTexels> kept_material_;
    std::vector<std::uint32_t> tables_;
    std::vector<std::uint32_t> words_; // copy of texture_words_
    int only_model_ = 0;
    std::uint64_t uploads_ = 0, uploaded_bytes_ = 0;
};

} // namespace firsthit::gl
