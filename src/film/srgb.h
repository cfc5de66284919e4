// srgb.h - from linear light to 8-bit sRGB, exactly rounded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// The sRGB code of a linear value by the formula, in double precision: clamped to [0, 1], no
/// number gives 0. The definition that SrgbTable is held against.
///
/// source  IEC 61966-2-1
std::uint8_t srgb_from_linear(float linear);

/// The same codes by table, about 1 ns each.
///
/// A code is constant between two floats, its threshold and that of the next code. The upper bits
/// of a float (exponent and 7 bits of mantissa) select a bucket that holds at most one threshold: a
/// bucket is 1/128 wide, relative, and codes grow by at most 255 * 1.055 / 2.4 a relative 1, at 1.
class SrgbTable {
  public:
    SrgbTable();

    /// code.size() = linear.size()
    void convert(std::span<const float> linear, std::span<std::uint8_t> code) const;

  private:
    static constexpr std::uint32_t kShift = 16;            // 23 mantissa bits less 7
    static constexpr std::uint32_t kLowest = 0x3900 << 16; // 2^-13: below the threshold of code 1
    static constexpr std::uint32_t kOne = 0x3F800000;      // 1.0f
    static constexpr std::size_t kBuckets = ((kOne - kLowest) >> kShift) + 1;

    std::array<std::uint8_t, kBuckets> first_code_{}; // of the bucket's first float
    std::array<float, 257> threshold_{};              // the first float of a code
};

} // namespace firsthit
