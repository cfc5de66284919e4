// tcb_spline.h - Kochanek-Bartels splines through keys: channels whose interpolation is tcb.
//
// The first and last key only shape the tangents: the spline runs from the second key to the last
// but one, and stands still outside. Fewer than four keys give no spline: the second key holds for
// ever (or the only one).
//
//     key   0     1 -------- 2 -------- 3     4
//           |     the spline runs here        |
//           shapes the tangent of 1           shapes the tangent of 3
//
// source  Kochanek and Bartels 1984, "Interpolating Splines with Local Tension, Continuity, and
// Bias
//         Control"; Lext, Assarsson and Möller 2000, "BART: A Benchmark for Animated Ray Tracing"
#pragma once

#include <firsthit/animation.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace firsthit {

/// The spline of translation or scale keys. At least one key.
glm::dvec3 evaluate_vector(const std::vector<TcbKey>& keys, double time_s);

/// The spline of rotation keys, a unit quaternion. At least one key. Two neighbours more than half
/// a turn apart are joined the short way.
///
/// source  Shoemake 1987, "Quaternion Calculus and Fast Animation" (squad)
glm::dquat evaluate_rotation(const std::vector<TcbKey>& keys, double time_s);

} // namespace firsthit
