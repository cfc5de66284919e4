// tone.cpp - exposure and tone mapping: how light becomes the numbers of a picture.
#include <firsthit/error.h>
#include <firsthit/film.h>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firsthit {
namespace {

glm::vec3 finite_light(const glm::vec3& color)
{
    const auto of = [](float x) { return x > 0 && std::isfinite(x) ? x : 0.0f; };
    return {of(color.x), of(color.y), of(color.z)};
}

/// source  Hill 2017, BakingLab, ACES.hlsl: a fit of the reference rendering transform and of the output
///         transform for sRGB, between two changes of primaries. Matrices here are column by column
glm::vec3 aces(const glm::vec3& color)
{
    constexpr glm::mat3 kToAces(0.59719f, 0.07600f, 0.02840f, //
        0.35458f, 0.90834f, 0.13383f,                         //
        0.04823f, 0.01566f, 0.83777f);
    constexpr glm::mat3 kFromAces(1.60475f, -0.10208f, -0.00327f, //
        -0.53108f, 1.10813f, -0.07276f,                           //
        -0.07367f, -0.00605f, 1.07602f);
    // Above this the fit is 1 to a float, and its squares stay finite.
    const glm::vec3 v = kToAces * glm::min(color, glm::vec3(1e6f));
    const glm::vec3 a = v * (v + 0.0245786f) - 0.000090537f;
    const glm::vec3 b = v * (0.983729f * v + 0.4329510f) + 0.238081f;
    return glm::clamp(kFromAces * (a / b), glm::vec3(0), glm::vec3(1));
}

/// source  Khronos 2024, "Khronos PBR Neutral Tone Mapper", specification
glm::vec3 khronos_pbr_neutral(const glm::vec3& color)
{
    constexpr float kStart = 0.8f - 0.04f; // of compression
    constexpr float kDesaturation = 0.15f;
    const float least = std::min({color.x, color.y, color.z});
    const float offset = least < 0.08f ? least - 6.25f * least * least : 0.04f;
    const glm::vec3 moved = color - offset;
    const float peak = std::max({moved.x, moved.y, moved.z});
    if (peak < kStart) return moved;
    constexpr float kRest = 1 - kStart;
    const float pressed = 1 - kRest * kRest / (peak + kRest - kStart);
    const float white = 1 - 1 / (kDesaturation * (peak - pressed) + 1);
    return glm::mix(moved * (pressed / peak), glm::vec3(pressed), white);
}

} // namespace

std::vector<float> toned(std::vector<float> color, const Tone& tone)
{
    constexpr double kMostExposure = 100;
    if (!(std::abs(tone.exposure_ev) <= kMostExposure))
        throw ArgumentError(
            fmt::format("exposure {} is out of range: -100 to 100", tone.exposure_ev));
    const auto factor = static_cast<float>(std::exp2(tone.exposure_ev));
    for (std::size_t k = 0; k + 3 <= color.size(); k += 3) {
        glm::vec3 light(color[k], color[k + 1], color[k + 2]);
        light *= factor;
        if (tone.map == ToneMap::aces) light = aces(finite_light(light));
        if (tone.map == ToneMap::khronos_pbr_neutral)
            light = khronos_pbr_neutral(finite_light(light));
        for (std::size_t c = 0; c < 3; ++c) color[k + c] = light[static_cast<int>(c)];
    }
    return color;
}

} // namespace firsthit
