// mip_levels.cpp - averages a texture down to one texel.
#include "scene/mip_levels.h"

#include "base/srgb.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace firsthit {
namespace {

/// Linear red, green, blue, alpha; row by row.
struct LinearLevel {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> texel;
};

glm::vec4 linear_texel(std::uint32_t rgba, const std::array<float, 256>& light)
{
    return {light[rgba & 255], light[(rgba >> 8) & 255], light[(rgba >> 16) & 255],
        static_cast<float>(rgba >> 24) / 255.0f};
}

std::uint32_t srgb_texel(const glm::vec4& linear, const SrgbTable& table)
{
    const auto alpha = static_cast<std::uint32_t>(std::lround(linear.w * 255.0f));
    return std::uint32_t(table.code(linear.x)) | (std::uint32_t(table.code(linear.y)) << 8) |
           (std::uint32_t(table.code(linear.z)) << 16) | (std::min(alpha, 255u) << 24);
}

/// Which texels a smaller one covers along one axis, and their shares. Half of an odd size 2n + 1
/// takes 2 + 1/n texels: parts of the first and the last of three.
struct Taps {
    int first = 0;
    std::size_t count = 1;
    std::array<float, 3> share{1, 0, 0};
};

Taps taps_of(int small, int small_size, int size)
{
    if (size == 1) return {};
    if (size % 2 == 0) return {2 * small, 2, {0.5f, 0.5f, 0.0f}};
    const float whole = static_cast<float>(size);
    const float n = static_cast<float>(small_size);
    const float s = static_cast<float>(small);
    return {2 * small, 3, {(n - s) / whole, n / whole, (s + 1) / whole}};
}

/// texel_at(x, y) gives the linear texel of the larger level.
template <class TexelAt>
LinearLevel half_level(int width, int height, const TexelAt& texel_at)
{
    LinearLevel half{std::max(1, width / 2), std::max(1, height / 2), {}};
    half.texel.reserve(
        static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const bool even = width % 2 == 0 && height % 2 == 0;
    for (int y = 0; y < half.height; ++y) {
        const Taps down = taps_of(y, half.height, height);
        for (int x = 0; x < half.width; ++x) {
            // Nearly all textures are even: four texels of equal share.
            if (even) {
                half.texel.push_back(
                    0.25f * ((texel_at(2 * x, 2 * y) + texel_at(2 * x + 1, 2 * y)) +
                                (texel_at(2 * x, 2 * y + 1) + texel_at(2 * x + 1, 2 * y + 1))));
                continue;
            }
            const Taps right = taps_of(x, half.width, width);
            glm::vec4 sum(0);
            for (std::size_t j = 0; j < down.count; ++j)
                for (std::size_t i = 0; i < right.count; ++i)
                    sum += down.share[j] * right.share[i] *
                           texel_at(
                               right.first + static_cast<int>(i), down.first + static_cast<int>(j));
            half.texel.push_back(sum);
        }
    }
    return half;
}

Texture::Level stored_level(const LinearLevel& linear)
{
    Texture::Level level{linear.width, linear.height, {}};
    level.texel.resize(linear.texel.size());
    std::transform(linear.texel.begin(), linear.texel.end(), level.texel.begin(),
        [&table = srgb_table()](const glm::vec4& texel) { return srgb_texel(texel, table); });
    return level;
}

} // namespace

void make_mip_levels(Texture& texture)
{
    texture.levels.resize(1);
    const Texture::Level& picture = texture.levels[0];
    if (picture.width == 1 && picture.height == 1) return;

    // From the stored picture only once: later levels come from unrounded light.
    const std::array<float, 256>& light = linear_from_srgb();
    LinearLevel linear = half_level(picture.width, picture.height, [&](int x, int y) {
        return linear_texel(
            picture.texel[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)], light);
    });
    texture.levels.push_back(stored_level(linear));
    while (linear.width > 1 || linear.height > 1) {
        linear = half_level(linear.width, linear.height, [&](int x, int y) {
            return linear.texel[std::size_t(y) * std::size_t(linear.width) + std::size_t(x)];
        });
        texture.levels.push_back(stored_level(linear));
    }
}

} // namespace firsthit
