// axes.h - the axes around which parts of robots turn.
#pragma once

#include <glm/vec3.hpp>

namespace firsthit {

inline constexpr glm::dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

} // namespace firsthit
