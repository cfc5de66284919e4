// environment_buffer.h - uploads the environment for shaders.
#pragma once

#include "gl/bindings.h"
#include "gl/device/objects.h"
#include "gl/scene/gpu_data.h"
#include "shade/shade_environment.h"

#include <cstdint>
#include <memory>

namespace firsthit::gl {

/// The texels of an EnvironmentMap on OpenGL. Maps never change, so a map is uploaded once.
class EnvironmentBuffer {
  public:
    /// Uploads the map where it is another one, and fills in the frame.
    /// is_used  whether a material reflects it, or it is seen in the background
    void update(const Environment& environment, bool is_used, FrameData& frame)
    {
        frame.environment = is_used;
        if (!is_used) return;
        const ShadeEnvironment shade = shade_environment(environment);
        for (std::size_t k = 0; k < 9; ++k)
            frame.environment_diffuse[k] = glm::vec4(shade.diffuse[k], 0);
        for (std::size_t k = 0; k < EnvironmentMap::kLevels; ++k)
            frame.environment_level[k] = {shade.side[k], shade.first[k], 0, 0};
        frame.environment_table = shade.table;
        frame.environment_cosine = shade.cosine;
        frame.environment_sine = shade.sine;
        frame.environment_strength = shade.strength;
        frame.environment_background = environment.background;
        if (map_ == environment.map) return;
        texels_.assign(environment.map->texels());
        uploaded_bytes_ += environment.map->texels().size_bytes();
        map_ = environment.map;
        check("uploading the environment");
    }

    /// Binds the texels as environment_tables.glsl declares them.
    void bind()
    {
        texture_.look_at(texels_, GL_RGBA32F, sizeof(glm::vec4));
        texture_.bind(kEnvironmentUnit);
    }

    std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    BufferTexture texture_;
    Buffer texels_;
    std::shared_ptr<const EnvironmentMap> map_; // kept, so that no other map has its address
    std::uint64_t uploaded_bytes_ = 0;
};

} // namespace firsthit::gl
