// noise.cpp - noise for textures.
#include "samples/noise.h"

#include <glm/common.hpp>

namespace firsthit {

float noise_at(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    std::uint32_t h = x * 0x8DA6B343u + y * 0xD8163841u + seed * 0xCB1AB31Fu;
    h = (h ^ 61u) ^ (h >> 16);
    h *= 9u;
    h ^= h >> 4;
    h *= 0x27D4EB2Du;
    h ^= h >> 15;
    return static_cast<float>(h & 0xFFFFu) / 65535.0f;
}

float smooth_noise(const glm::vec2& place, const glm::ivec2& cells, std::uint32_t seed)
{
    const float fx = place.x * static_cast<float>(cells.x);
    const float fy = place.y * static_cast<float>(cells.y);
    const auto ix = static_cast<std::uint32_t>(fx);
    const auto iy = static_cast<std::uint32_t>(fy);
    const auto columns = static_cast<std::uint32_t>(cells.x);
    const auto rows = static_cast<std::uint32_t>(cells.y);
    const auto at = [&](std::uint32_t dx, std::uint32_t dy) {
        return noise_at((ix + dx) % columns, (iy + dy) % rows, seed);
    };
    const auto ease = [](float t) { return t * t * (3.0f - 2.0f * t); };
    const float u = ease(fx - static_cast<float>(ix));
    const float v = ease(fy - static_cast<float>(iy));
    return glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
}

} // namespace firsthit
