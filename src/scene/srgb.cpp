// srgb.cpp - between 8-bit sRGB and linear light, by tables.
#include "scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

double linear_from_srgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The light of `count` values from `first` in steps of 1 / 255.
template <std::size_t count>
std::array<float, count> light_table(double first)
{
    std::array<float, count> table;
    for (std::size_t k = 0; k < count; ++k)
        table[k] = static_cast<float>(linear_from_srgb((static_cast<double>(k) + first) / 255));
    return table;
}

} // namespace

const std::array<float, 256>& linear_from_srgb8()
{
    static const std::array<float, 256> table = light_table<256>(0.0);
    return table;
}

std::uint8_t srgb8_from_linear(float linear)
{
    // Where 8-bit values give way to the next one: half-way between them in sRGB.
    static const std::array<float, 255> edge = light_table<255>(0.5);
    return static_cast<std::uint8_t>(
        std::upper_bound(edge.begin(), edge.end(), linear) - edge.begin());
}

} // namespace firsthit
