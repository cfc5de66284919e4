// noise.h - noise for textures, with the same bits on every machine.
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace firsthit {

/// 0 to 1, the same for the same place; after Wang 1997, "Integer Hash Function".
float noise_at(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

/// Smooth noise, 0 to 1, which repeats.
/// place  in [0, 1) on both axes
/// cells  how many a period has on each axis, 1 or more
float smooth_noise(const glm::vec2& place, const glm::ivec2& cells, std::uint32_t seed);

} // namespace firsthit
