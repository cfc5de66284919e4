// srgb.cpp - from linear light to 8-bit sRGB, exactly rounded.
#include "film/srgb.h"

#include <bit>
#include <cmath>
#include <limits>

namespace firsthit {

std::uint8_t srgb_from_linear(float linear)
{
    if (!(linear > 0.0f)) return 0;
    if (linear >= 1.0f) return 255;
    const double x = linear;
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::floor(255.0 * s + 0.5));
}

SrgbTable::SrgbTable()
{
    // Bisect the floats, whose bits are ordered like their values, for the first one of each code.
    std::uint32_t low = 0;
    for (std::uint32_t code = 1; code < 256; ++code) {
        std::uint32_t high = kOne;
        while (high - low > 1) {
            const std::uint32_t middle = low + (high - low) / 2;
            (srgb_from_linear(std::bit_cast<float>(middle)) >= code ? high : low) = middle;
        }
        threshold_[code] = std::bit_cast<float>(high);
        low = high - 1;
    }
    threshold_[256] = std::numeric_limits<float>::infinity();
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
        const auto bits = static_cast<std::uint32_t>(kLowest + (bucket << kShift));
        first_code_[bucket] = srgb_from_linear(std::bit_cast<float>(bits));
    }
}

void SrgbTable::convert(std::span<const float> linear, std::span<std::uint8_t> code) const
{
    constexpr float lowest = std::bit_cast<float>(kLowest);
    for (std::size_t k = 0; k < linear.size(); ++k) {
        // Written so that no number becomes `lowest`, hence 0.
        const float above = linear[k] > lowest ? linear[k] : lowest;
        const float x = above < 1.0f ? above : 1.0f;
        const std::uint8_t first =
            first_code_[(std::bit_cast<std::uint32_t>(x) - kLowest) >> kShift];
        code[k] = static_cast<std::uint8_t>(first + (x >= threshold_[first + 1u]));
    }
}

} // namespace firsthit
