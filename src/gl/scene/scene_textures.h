// scene_textures.h - the posed scene where the gpu engine's shaders fetch it.
#pragma once

#include "gl/bindings.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"

namespace firsthit::gl {

/// The arrays of SceneBuffers as textures: what scene.glsl declares.
class SceneTextures {
  public:
    /// After the scene was posed.
    /// throws  DeviceError: an array is too long for the driver
    void bind(const SceneBuffers& scene)
    {
        show(index_, scene.index(), GL_RGB32UI, 12, kIndexUnit);
        show(eye_, scene.eye(), GL_RGBA32F, 16, kEyeUnit);
        show(world_, scene.world(), GL_RGBA32F, 16, kWorldUnit);
        show(normal_, scene.normal(), GL_RGBA32F, 16, kNormalUnit);
        show(uv_, scene.uv(), GL_RG32F, 8, kUvUnit);
        show(material_, scene.material(), GL_R32UI, 4, kTriangleMaterialUnit);
    }

  private:
    static void show(BufferTexture& texture, const Buffer& buffer, GLenum format,
        std::size_t element_bytes, GLuint unit)
    {
        texture.look_at(buffer, format, element_bytes);
        texture.bind(unit);
    }

    BufferTexture index_, eye_, world_, normal_, uv_, material_;
};

} // namespace firsthit::gl
