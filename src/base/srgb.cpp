// srgb.cpp - converts between 8-bit sRGB codes and linear light.
#include "base/srgb.h"

#include <cmath>
#include <limits>

namespace firsthit {
namespace {

float from_srgb(double s)
{
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

} // namespace

const std::array<float, 256>& linear_from_srgb()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> linear{};
        for (std::size_t code = 0; code < linear.size(); ++code) {
            linear[code] = from_srgb(static_cast<double>(code) / 255);
        }
        return linear;
    }();
    return table;
}

float linear_of_srgb(double value)
{
    if (!(value > 0)) return 0;
    if (value >= 1) return 1;
    // Codes of 8 bits are most of what files have.
    const double code = value * 255;
    const double whole = std::floor(code + 0.5);
    if (whole / 255 == value) return linear_from_srgb()[static_cast<std::size_t>(whole)];
    return from_srgb(value);
}

double srgb_value(float linear)
{
    if (!(linear > 0.0f)) return 0;
    if (linear >= 1.0f) return 1;
    const double x = linear;
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

std::uint8_t srgb_from_linear(float linear)
{
    return static_cast<std::uint8_t>(std::floor(255.0 * srgb_value(linear) + 0.5));
}

SrgbTable::SrgbTable()
{
    // Finds the first float of each code by bisection over the bits, which are ordered like values.
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

void SrgbTable::codes(std::span<const float> linear, std::span<std::uint8_t> codes) const
{
    for (std::size_t k = 0; k < linear.size(); ++k) codes[k] = code(linear[k]);
}

const SrgbTable& srgb_table()
{
    static const SrgbTable table;
    return table;
}

} // namespace firsthit
