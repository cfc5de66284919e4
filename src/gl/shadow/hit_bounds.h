// hit_bounds.h - the parts of the lights' projections that the hits of a picture fill.
#pragma once

#include "gl/device/objects.h"
#include "shadow/map/hit_bounds.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// Finds them by a compute pass; 120 bytes a light come back.
class HitBounds {
  public:
    /// program  hit_bounds.comp. Its blocks, uniforms and textures are bound already: frame.glsl,
    ///          scene.glsl, lights.glsl, and items or hits
    /// size     of the part, samples
    /// bounds   (lights), what add_hits (shadow/map/hit_bounds.h) says but for roundings of float;
    ///          waits for it
    void find(const Program& program, glm::ivec2 size, std::span<LightBounds> bounds);

  private:
    Buffer keys_; // (lights, faces, 5), see hit_bounds.comp
    std::vector<std::uint32_t> read_;
};

} // namespace firsthit::gl
