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

/// Finds 8-bit values by where they give way to the next one: half-way between them in sRGB.
class CodeTable {
  public:
    CodeTable() : edge_(light_table<255>(0.5))
    {
        for (std::size_t bucket = 0; bucket < first_code_.size(); ++bucket)
            first_code_[bucket] = static_cast<std::uint8_t>(
                std::upper_bound(edge_.begin(), edge_.end(),
                    static_cast<float>(bucket) / static_cast<float>(kBuckets)) -
                edge_.begin());
    }

    std::uint8_t code_of(float linear) const
    {
        if (!(linear > 0)) return 0;
        if (linear >= 1) return 255;
        // At most four codes share a bucket, where sRGB is steepest.
        std::size_t code = first_code_[static_cast<std::size_t>(linear * float(kBuckets))];
        while (code < edge_.size() && linear >= edge_[code]) ++code;
        return static_cast<std::uint8_t>(code);
    }

  private:
    static constexpr std::size_t kBuckets = 1024;
    std::array<float, 255> edge_;
    std::array<std::uint8_t, kBuckets> first_code_{};
};

} // namespace

const std::array<float, 256>& linear_from_srgb8()
{
    static const std::array<float, 256> table = light_table<256>(0.0);
    return table;
}

std::uint8_t srgb8_from_linear(float linear)
{
    static const CodeTable table;
    return table.code_of(linear);
}

} // namespace firsthit
