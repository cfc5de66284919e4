// srgb.h - converts between 8-bit sRGB codes and linear light.
//
// source  IEC 61966-2-1
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// The linear light, in [0, 1], of each code.
const std::array<float, 256>& linear_from_srgb();

/// The linear light of an sRGB value, both in [0, 1]; values outside are clamped, NaN gives 0.
/// That of a code / 255 is the one of the table above.
float linear_of_srgb(double value);

/// The sRGB value, in [0, 1], of a linear value clamped to [0, 1]; NaN gives 0.
double srgb_value(float linear);

/// The code nearest to a linear value, by the formula in double precision. The value is clamped to
/// [0, 1]; NaN gives 0. This is the definition that SrgbTable has to equal.
std::uint8_t srgb_from_linear(float linear);

/// The same codes from a table, in about 1 ns each.
///
/// A code is constant between two floats, its own threshold and that of the next code. The upper
/// bits of a float (exponent and 7 bits of mantissa) select a bucket. No bucket holds more than one
/// threshold: its relative width is at most 1/128, and codes grow by at most 255 * 1.055 / 2.4 =
/// 112 per relative change of 1 (this maximum is at 1).
class SrgbTable {
  public:
    SrgbTable();

    std::uint8_t code(float linear) const
    {
        constexpr float lowest = std::bit_cast<float>(kLowest);
        // Written so that NaN becomes `lowest`, which has code 0.
        const float above = linear > lowest ? linear : lowest;
        const float x = above < 1.0f ? above : 1.0f;
        const std::uint8_t first =
            first_code_[(std::bit_cast<std::uint32_t>(x) - kLowest) >> kShift];
        return static_cast<std::uint8_t>(first + (x >= threshold_[first + 1u]));
    }

    /// Converts an array. codes.size() must equal linear.size().
    void codes(std::span<const float> linear, std::span<std::uint8_t> codes) const;

  private:
    static constexpr std::uint32_t kShift = 16;            // 23 mantissa bits less 7
    static constexpr std::uint32_t kLowest = 0x3900 << 16; // 2^-13: below the threshold of code 1
    static constexpr std::uint32_t kOne = 0x3F800000;      // 1.0f
    static constexpr std::size_t kBuckets = ((kOne - kLowest) >> kShift) + 1;

    std::array<std::uint8_t, kBuckets> first_code_{}; // of the bucket's first float
    std::array<float, 257> threshold_{};              // the first float of a code
};

/// The table, made at the first call.
const SrgbTable& srgb_table();

} // namespace firsthit
