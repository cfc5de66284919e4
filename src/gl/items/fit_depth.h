// fit_depth.h - how near and how far is what a pencil sees?
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

/// A range that holds what the samples see of the triangles, as narrow as it can be: triangles are
/// cut to the pencil's sides. Where something comes nearer than far / kMostDepths, near is that: with
/// 24 bits a nearer plane would leave too little for all the rest.
///
/// corner  (V) eye space
/// index   (T)
/// source  Robert and Schoepke 2006, section 3.1: "an optimal projection setup"
DepthRange fit_depth(std::span<const glm::vec4> corner, std::span<const glm::uvec3> index,
    const Pencil& pencil, Tasks& tasks);

/// far / near at most: then neighbouring depths of 24 bits differ by 2^-12 of the depth at far.
inline constexpr double kMostDepths = 4096;

} // namespace firsthit::gl
