// weld.h - which of many values are the same.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// Values numbered without repetition, in order of first appearance.
struct Welded {
    std::vector<std::uint32_t> number; // of each value
    std::vector<std::uint32_t> first;  // where each number appears first
};

/// Finds equal values: the same bits, except that -0 is 0. NaN equals itself.
Welded weld(std::span<const glm::vec3> values);

/// The same for three whole numbers each.
Welded weld(std::span<const glm::uvec3> values);

} // namespace firsthit
