// fit_depth.h - finds the range of depths that a pencil sees.
#pragma once

#include "base/tasks.h"
#include "exact/pencil.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace firsthit::gl {

/// Depths along the view axis, 0 < near < far.
struct DepthRange {
    double near = 1;
    double far = 2;
};

/// The smallest range that contains the depths of all triangles in the pencil: triangles are
/// clipped to its sides. near is at least far / kMostDepths, even if triangles are nearer, because
/// with 24 bits a nearer plane would leave too little precision for other depths.
///
/// corner  (V) eye space
/// index   (T)
/// source  Robert and Schoepke 2006, section 3.1: "an optimal projection setup"
DepthRange fit_depth(std::span<const glm::vec4> corner, std::span<const glm::uvec3> index,
    const Pencil& pencil, Tasks& tasks);

/// The greatest far / near. Neighbouring depths of 24 bits then differ by 2^-12 of the depth at
/// `far`.
inline constexpr double kMostDepths = 4096;

} // namespace firsthit::gl
