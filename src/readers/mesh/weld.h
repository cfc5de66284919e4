// weld.h - which of many values are the same.
#pragma once

#include "base/tasks.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// Values numbered without repetition, in order of first appearance.
struct Welded {
    std::vector<std::uint32_t> number; // of each value
    std::vector<std::uint32_t> first;  // where each number appears first
};

/// Finds equal values: the same bits, except that -0 is 0. NaN equals itself. The numbers do not depend on
/// the number of threads.
Welded weld(std::span<const glm::vec3> values, Tasks& tasks);

/// Four whole numbers: those of a position, a normal, texture coordinates and a colour, or any others.
using VertexKey = std::array<std::uint32_t, 4>;

/// The same for those.
Welded weld(std::span<const VertexKey> values, Tasks& tasks);

/// Equal values have equal keys; -0 is 0.
VertexKey key_bits(const glm::vec4& value);

} // namespace firsthit
