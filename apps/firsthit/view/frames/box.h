// box.h - an axis-aligned box in world space.
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace firsthit::cli::view {

/// Least and greatest corner.
using Box = std::array<glm::dvec3, 2>;

} // namespace firsthit::cli::view
