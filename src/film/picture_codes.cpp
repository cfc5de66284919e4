// picture_codes.cpp - a picture's colours as 8-bit sRGB, row by row.
#include "film/picture_codes.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit {
namespace {

constexpr int kBayerSide = 8;

/// Bayer's matrix: its values 0 to 63 are spread as evenly as they can be in every square of 2, 4 and 8.
constexpr auto kBayer = [] {
    std::array<std::array<float, kBayerSide>, kBayerSide> threshold{};
    for (unsigned y = 0; y < kBayerSide; ++y) {
        for (unsigned x = 0; x < kBayerSide; ++x) {
            unsigned value = 0;
            for (unsigned bit = 0; bit < 3; ++bit) {
                const unsigned low_x = x >> bit & 1, low_y = y >> bit & 1;
                value = value << 2 | (low_x ^ low_y) << 1 | low_y;
            }
            threshold[y][x] = (float(value) + 0.5f) / 64;
        }
    }
    return threshold;
}();

/// What dithering looks up, made once.
struct DitherTable {
    const SrgbTable& nearest = srgb_table();
    const std::array<float, 256>& light = linear_from_srgb();
    std::array<float, 256>
        per_step{}; // 1 / (light of the next code - that of this); the last has none

    DitherTable()
    {
        for (std::size_t code = 0; code < 255; ++code)
            per_step[code] = 1 / (light[code + 1] - light[code]);
    }

    DitherCode lower(float linear) const
    {
        const float value = linear > 0 ? linear : 0.0f; // NaN too
        const unsigned near = nearest.code(value);
        const unsigned code = near - (value < light[near]);
        // Below 1 also where a rounding or a value above 1 would have it otherwise.
        const float fraction = std::min((value - light[code]) * per_step[code], 0x1.fffffep-1f);
        return {static_cast<std::uint8_t>(code), fraction};
    }
};

const DitherTable& dither_table()
{
    static const DitherTable table;
    return table;
}

/// Codes of a row whose pixels take `channels` bytes.
/// thresholds  of a row of the pattern, from that of the first pixel on
void dither_row(std::span<const float> color, const std::array<float, kBayerSide>& thresholds,
    std::size_t channels, std::span<std::uint8_t> codes)
{
    const DitherTable& table = dither_table();
    std::array<float, 3> last{0, 0, 0}; // often that of the pixel before, as in a background
    std::array<DitherCode, 3> lower{};
    for (std::size_t x = 0; 3 * x < color.size(); ++x) {
        const float threshold = thresholds[x % kBayerSide];
        for (std::size_t c = 0; c < 3; ++c) {
            const float linear = color[3 * x + c];
            if (linear != last[c]) {
                last[c] = linear;
                lower[c] = table.lower(linear);
            }
            codes[channels * x + c] =
                static_cast<std::uint8_t>(lower[c].code + (lower[c].fraction > threshold));
        }
    }
}

} // namespace

DitherCode dither_code(float linear)
{
    return dither_table().lower(linear);
}

float dither_threshold(int x, int y)
{
    return kBayer[unsigned(y) % kBayerSide][unsigned(x) % kBayerSide];
}

void PictureCodes::row(int y, std::span<std::uint8_t> codes) const
{
    const auto width = static_cast<std::size_t>(color_.width);
    const std::size_t channels = alpha_.empty() ? 3 : 4;
    const std::span<const float> color =
        color_.value.subspan(static_cast<std::size_t>(y) * width * 3, width * 3);
    std::array<float, kBayerSide> thresholds{};
    for (int x = 0; x < int(kBayerSide); ++x)
        thresholds[std::size_t(x)] = dither_threshold(origin_.x + x, origin_.y + y);
    const SrgbTable& table = srgb_table();
    if (!dither_ && alpha_.empty()) return table.codes(color, codes);
    if (dither_)
        dither_row(color, thresholds, channels, codes);
    else
        for (std::size_t k = 0; k < color.size(); ++k)
            codes[k / 3 * channels + k % 3] = table.code(color[k]);
    if (alpha_.empty()) return;
    for (std::size_t x = 0; x < width; ++x) {
        const float alpha = alpha_[static_cast<std::size_t>(y) * width + x];
        codes[4 * x + 3] =
            static_cast<std::uint8_t>(std::floor(255 * std::clamp(alpha, 0.0f, 1.0f) + 0.5f));
    }
}

} // namespace firsthit
