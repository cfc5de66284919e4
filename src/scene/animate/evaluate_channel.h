// evaluate_channel.h - the value of a channel at a time.
#pragma once

#include <firsthit/animation.h>

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <span>

namespace firsthit {

/// How many numbers a value of the channel has: see Channel::Path. 0 where it has no key.
std::size_t components_of(const Channel& channel);

/// Writes the components_of(channel) numbers of the channel's value. A rotation is a unit quaternion
/// (x, y, z, w). The channel has a key at least and is sound (check_scene).
///
/// value   as many numbers as the channel has, or fewer: the rest is left out
/// source  glTF 2.0 specification, appendix C "Animation Sampler Interpolation Modes"
void evaluate(const Channel& channel, double time_s, std::span<double> value);

/// translation * rotation * scale.
glm::dmat4 matrix_of(const NodeTransform& transform);

} // namespace firsthit
