// painted_things.cpp - textures that are pictures: rug, bindings of books, painting and print.
#include "samples/noise.h"
#include "samples/room/textures/painted_texture.h"
#include "samples/room/textures/textures.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit {
namespace {

constexpr glm::vec3 kBrick(0.40f, 0.09f, 0.055f), kNavy(0.035f, 0.06f, 0.15f),
    kSand(0.60f, 0.47f, 0.28f), kOchre(0.52f, 0.27f, 0.06f);

glm::vec3 rug_at(const glm::vec2& place)
{
    // Distance to the edge in parts of the short side; the rug is 3 : 2.
    const float edge =
        std::min(1.5f * std::min(place.x, 1 - place.x), std::min(place.y, 1 - place.y));
    const glm::vec2 cell = place * glm::vec2(24, 16);
    const glm::vec2 in(std::abs(part_of(cell.x) - 0.5f), std::abs(part_of(cell.y) - 0.5f));
    const float diamond = in.x + in.y;
    const float wool = 0.85f + 0.3f * smooth_noise(place, {256, 256}, 51);

    glm::vec3 color = kBrick;
    if (edge < 0.025f) {
        color = kNavy;
    } else if (edge < 0.045f || (edge > 0.125f && edge < 0.14f)) {
        color = kSand;
    } else if (edge <= 0.125f) {
        color = diamond < 0.22f ? kSand : diamond < 0.38f ? kBrick : kNavy;
    } else {
        // Large diamonds around the middle, small ones between.
        const glm::vec2 from(std::abs(place.x - 0.5f) * 1.5f, std::abs(place.y - 0.5f));
        const float ring = from.x + from.y;
        if (ring < 0.10f)
            color = kOchre;
        else if (ring < 0.13f || (ring > 0.30f && ring < 0.33f))
            color = kSand;
        else if (ring < 0.30f)
            color = diamond < 0.20f ? kSand : kNavy;
        else if (diamond < 0.16f)
            color = kOchre;
    }
    return color * wool;
}

glm::vec3 bindings_at(const glm::vec2& place)
{
    constexpr std::array<glm::vec3, kBindings> kColors{{{0.38f, 0.06f, 0.04f},
        {0.05f, 0.13f, 0.26f}, {0.10f, 0.22f, 0.10f}, {0.55f, 0.40f, 0.16f}, {0.22f, 0.09f, 0.04f},
        {0.58f, 0.52f, 0.42f}, {0.06f, 0.22f, 0.24f}, {0.30f, 0.08f, 0.18f}}};
    const auto binding = static_cast<int>(place.x * kBindings);
    const float v = place.y;
    const glm::vec3 cloth = kColors[static_cast<std::size_t>(binding)] *
                            (0.85f + 0.3f * smooth_noise(place, {64, 64}, 61));
    const glm::vec3 gold(0.62f, 0.46f, 0.16f);
    const bool pale = binding == 3 || binding == 5;
    const glm::vec3 print = pale ? glm::vec3(0.12f, 0.06f, 0.03f) : gold;
    const float kind = chance(binding, 62);
    if (v > 0.08f && v < 0.10f) return print;
    if (v > 0.90f && v < 0.92f) return print;
    const float low = 0.55f + 0.12f * kind;
    if (v > low && v < low + 0.18f) {
        // A title: lines of blocks on a dark or pale label.
        const float line = part_of((v - low) * 22);
        const float letter =
            chance(static_cast<int>(place.x * 256) * 8 + static_cast<int>(v * 64), 63);
        return line > 0.35f && letter > 0.35f ? print : 0.7f * cloth;
    }
    return cloth;
}

/// The height of a row of hills.
float ridge_at(float x, int cells, std::uint32_t seed)
{
    return smooth_noise({x, 0}, {cells, 1}, seed) +
           0.3f * smooth_noise({x, 0}, {cells * 4, 1}, seed);
}

glm::vec3 landscape_at(const glm::vec2& place)
{
    const float brush = 0.9f + 0.2f * smooth_noise(place, {32, 64}, 71);
    glm::vec3 color = glm::mix(glm::vec3(0.80f, 0.45f, 0.20f), glm::vec3(0.16f, 0.27f, 0.45f),
        std::min(1.0f, std::max(0.0f, 1.8f * (place.y - 0.45f))));
    const glm::vec2 sun = (place - glm::vec2(0.64f, 0.60f)) * glm::vec2(1.4f, 1);
    if (sun.x * sun.x + sun.y * sun.y < 0.0045f) color = {0.95f, 0.80f, 0.45f};
    if (place.y < 0.40f + 0.16f * ridge_at(place.x, 3, 72)) color = {0.25f, 0.24f, 0.36f};
    if (place.y < 0.26f + 0.16f * ridge_at(place.x, 4, 73)) color = {0.13f, 0.21f, 0.20f};
    if (place.y < 0.10f + 0.18f * ridge_at(place.x, 5, 74)) color = {0.22f, 0.26f, 0.08f};
    return color * brush;
}

glm::vec3 poster_at(const glm::vec2& place)
{
    const glm::vec3 page(0.74f, 0.68f, 0.55f);
    const auto inside = [&](const glm::vec2& middle, float radius) {
        const glm::vec2 d = (place - middle) * glm::vec2(1, 1.4f);
        return d.x * d.x + d.y * d.y < radius * radius;
    };
    if (std::min({place.x, 1 - place.x, place.y, 1 - place.y}) < 0.06f) return page;
    if (inside({0.40f, 0.62f}, 0.22f)) return place.x < 0.40f ? kBrick : kOchre;
    if (inside({0.62f, 0.42f}, 0.20f))
        return place.y < 0.42f ? kNavy : glm::vec3(0.10f, 0.30f, 0.30f);
    if (place.y < 0.22f && part_of(place.x * 14) < 0.5f) return kNavy;
    return page;
}

} // namespace

Texture make_rug()
{
    return paint_texture("rug", 512, rug_at);
}

Texture make_bindings()
{
    return paint_texture("bindings", 256, bindings_at);
}

Texture make_landscape()
{
    return paint_texture("landscape", 256, landscape_at);
}

Texture make_poster()
{
    return paint_texture("poster", 256, poster_at);
}

} // namespace firsthit
