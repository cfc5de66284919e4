// srgb_table.cpp - linear light of 8-bit sRGB.
#include "shade/srgb_table.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace firsthit {

const float* linear_of_srgb()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> linear{};
        for (std::size_t i = 0; i < linear.size(); ++i) {
            const double c = static_cast<double>(i) / 255.0;
            linear[i] =
                static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
        }
        return linear;
    }();
    return table.data();
}

} // namespace firsthit
