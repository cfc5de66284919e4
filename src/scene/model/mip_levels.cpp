// mip_levels.cpp - halves pictures.
#include "scene/model/mip_levels.h"

#include "base/srgb.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

glm::vec4 linear_pixel(std::uint32_t rgba, const std::array<float, 256>& light)
{
    return {light[rgba & 255], light[(rgba >> 8) & 255], light[(rgba >> 16) & 255],
        static_cast<float>(rgba >> 24) / 255.0f};
}

/// Code / 255.
std::array<float, 256> shares_of_codes()
{
    std::array<float, 256> share{};
    for (std::size_t code = 0; code < share.size(); ++code)
        share[code] = static_cast<float>(code) / 255.0f;
    return share;
}

/// Which pixels a smaller one covers along one axis, and their shares. Half of an odd size 2n + 1
/// takes 2 + 1/n pixels: parts of the first and the last of three.
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

/// pixel_at(x, y) gives a linear pixel of the larger picture.
template <class PixelAt>
LinearPicture halve(int width, int height, const PixelAt& pixel_at)
{
    LinearPicture half{std::max(1, width / 2), std::max(1, height / 2), {}};
    half.pixel.reserve(
        static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const bool even = width % 2 == 0 && height % 2 == 0;
    for (int y = 0; y < half.height; ++y) {
        const Taps down = taps_of(y, half.height, height);
        for (int x = 0; x < half.width; ++x) {
            // Nearly all are even: four pixels of equal share.
            if (even) {
                half.pixel.push_back(
                    0.25f * ((pixel_at(2 * x, 2 * y) + pixel_at(2 * x + 1, 2 * y)) +
                                (pixel_at(2 * x, 2 * y + 1) + pixel_at(2 * x + 1, 2 * y + 1))));
                continue;
            }
            const Taps right = taps_of(x, half.width, width);
            glm::vec4 sum(0);
            for (std::size_t j = 0; j < down.count; ++j)
                for (std::size_t i = 0; i < right.count; ++i)
                    sum += down.share[j] * right.share[i] *
                           pixel_at(
                               right.first + static_cast<int>(i), down.first + static_cast<int>(j));
            half.pixel.push_back(sum);
        }
    }
    return half;
}

} // namespace

LinearPicture half_of(const Picture& picture, Encoding encoding)
{
    const std::array<float, 256> light =
        encoding == Encoding::srgb ? linear_from_srgb() : shares_of_codes();
    return halve(picture.width, picture.height, [&](int x, int y) {
        return linear_pixel(
            picture.pixel[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)], light);
    });
}

LinearPicture half_of(const LinearPicture& picture)
{
    return halve(picture.width, picture.height, [&](int x, int y) {
        return picture.pixel[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
    });
}

} // namespace firsthit
