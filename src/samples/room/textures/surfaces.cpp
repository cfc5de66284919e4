// surfaces.cpp - floor, wood, plaster and cloth.
#include "samples/room/textures/textures.h"

#include "samples/noise.h"
#include "samples/room/textures/painted_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit {
namespace {

/// Streaks along u, 0 to 1.
float grain_at(const glm::vec2& place, std::uint32_t seed)
{
    return 0.5f * smooth_noise(place, {4, 32}, seed) +
           0.3f * smooth_noise(place, {8, 128}, seed + 1) +
           0.2f * smooth_noise(place, {16, 256}, seed + 2);
}

glm::vec3 planks_at(const glm::vec2& place)
{
    constexpr int kRows = 16;
    const auto row = static_cast<int>(place.y * kRows);
    const float across = place.y * kRows - static_cast<float>(row);
    // Two planks a row, shifted by a part of their length from row to row.
    const float along = 2 * part_of(place.x + 0.125f * static_cast<float>(row * 3 % 8));
    const auto plank = static_cast<int>(along);
    const float own = chance(row * 2 + plank, 11);
    const float from_edge = std::min({across, 1 - across, 12 * (along - static_cast<float>(plank)),
        12 * (static_cast<float>(plank + 1) - along)});
    const float joint = from_edge < 0.035f ? 0.35f : 1.0f;

    const glm::vec2 shifted(part_of(place.x + own), part_of(place.y + 0.5f * own));
    const float grain = grain_at(shifted, 12);
    const glm::vec3 oak = glm::vec3(0.42f, 0.25f, 0.12f) * (0.80f + 0.35f * own);
    return oak * (0.66f + 0.62f * grain) * joint;
}

glm::vec3 wood_at(const glm::vec2& place, const glm::vec3& color)
{
    const float rings = part_of(6 * smooth_noise(place, {2, 8}, 21) + 8 * place.y);
    const float ring = rings < 0.8f ? rings / 0.8f : (1 - rings) / 0.2f;
    return color * (0.72f + 0.20f * ring + 0.42f * grain_at(place, 22));
}

glm::vec3 plaster_at(const glm::vec2& place, const glm::vec3& color)
{
    const float strokes = 0.5f * smooth_noise(place, {8, 4}, 31) +
                          0.3f * smooth_noise(place, {32, 16}, 32) +
                          0.2f * smooth_noise(place, {128, 64}, 33);
    return color * (0.90f + 0.20f * strokes);
}

glm::vec3 cloth_at(const glm::vec2& place, const glm::vec3& color)
{
    // Threads over and under one another, as on a chessboard.
    constexpr int kThreads = 32;
    const glm::vec2 thread = place * static_cast<float>(kThreads);
    const auto x = static_cast<int>(thread.x), y = static_cast<int>(thread.y);
    const bool over = (x + y) % 2 == 0;
    const float across = over ? thread.y - static_cast<float>(y) : thread.x - static_cast<float>(x);
    const float round = 4 * across * (1 - across);
    const float own = chance(over ? y : x + kThreads, 41);
    return color * (0.70f + 0.26f * round + 0.14f * own);
}

} // namespace

Texture make_planks()
{
    return paint_texture("planks", 512, planks_at);
}

Texture make_wood(std::string name, const glm::vec3& color)
{
    return paint_texture(std::move(name), 256, color, wood_at);
}

Texture make_plaster(std::string name, const glm::vec3& color)
{
    return paint_texture(std::move(name), 256, color, plaster_at);
}

Texture make_cloth(std::string name, const glm::vec3& color)
{
    return paint_texture(std::move(name), 128, color, cloth_at);
}

} // namespace firsthit
