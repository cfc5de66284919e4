// hit_bounds.h - finds the bounds of the visible hits on the faces of each light.
#pragma once

#include "gl/device/objects.h"
#include "shadow/map/hit_bounds.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// Finds the bounds by a compute pass, and reads back 120 bytes for each light.
class HitBounds {
  public:
    /// Waits for OpenGL.
    /// program  hit_bounds.comp. The blocks and textures that it reads must be bound (frame.glsl,
    ///          scene.glsl, lights.glsl, and items or hits)
    /// size     of the section, samples
    /// bounds   (lights) receives the bounds. They differ from those of add_hits
    ///          (shadow/map/hit_bounds.h) only by rounding errors of float
    void find(const Program& program, glm::ivec2 size, std::span<LightBounds> bounds);

  private:
    Buffer keys_; // (lights, faces, 5), see hit_bounds.comp
    std::vector<std::uint32_t> read_;
};

} // namespace firsthit::gl
