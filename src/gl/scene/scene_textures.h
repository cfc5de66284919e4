// scene_textures.h - binds the posed scene as buffer textures for the gpu engine's shaders.
#pragma once

#include "gl/bindings.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"

namespace firsthit::gl {

/// The arrays of SceneBuffers as the buffer textures that scene.glsl declares.
class SceneTextures {
  public:
    /// Binds the textures. To be called after the scene was posed.
    /// throws  DeviceError: an array is too long for the driver
    void bind(const SceneBuffers& scene)
    {
        bind_array(index_, scene.index(), GL_RGB32UI, 12, kIndexUnit);
        bind_array(eye_, scene.eye(), GL_RGBA32F, 16, kEyeUnit);
        bind_array(world_, scene.world(), GL_RGBA32F, 16, kWorldUnit);
        bind_array(normal_, scene.normal(), GL_RGBA32F, 16, kNormalUnit);
        bind_array(uv_, scene.uv(), GL_RG32F, 8, kUvUnit);
        bind_array(material_, scene.material(), GL_R32UI, 4, kTriangleMaterialUnit);
        bind_array(uv1_, scene.uv1(), GL_RG32F, 8, kSecondUvUnit);
        bind_array(color_, scene.color(), GL_RGBA32F, 16, kVertexColorUnit);
        bind_array(tangent_, scene.tangent(), GL_RGBA32F, 16, kTangentUnit);
    }

  private:
    static void bind_array(BufferTexture& texture, const Buffer& buffer, GLenum format,
        std::size_t element_bytes, GLuint unit)
    {
        texture.look_at(buffer, format, element_bytes);
        texture.bind(unit);
    }

    BufferTexture index_, eye_, world_, normal_, uv_, material_, uv1_, color_, tangent_;
};

} // namespace firsthit::gl
