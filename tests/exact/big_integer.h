// big_integer.h - whole numbers of up to 960 bits, so that floats can be calculated with exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace firsthit::test {

/// A sum of limbs with signs, each times a power of 2^24. Slow and simple.
class BigInteger {
  public:
    BigInteger() = default;

    /// x / 2^-149, which is whole for every finite float.
    static BigInteger of_float(float x)
    {
        int exponent = 0;
        const double mantissa = std::frexp(double(x), &exponent); // 24 bits
        if (x == 0) return {};
        const auto whole = std::int64_t(std::ldexp(mantissa, 24));
        int shift = exponent - 24 + 149;
        std::int64_t value = whole;
        for (; shift < 0; ++shift) value /= 2; // zeros: x is a multiple of 2^-149
        BigInteger result;
        result.limb_[std::size_t(shift / 24)] = value << (shift % 24);
        result.carry();
        return result;
    }

    static BigInteger one()
    {
        BigInteger result;
        result.limb_[0] = 1;
        return result;
    }

    BigInteger operator+(const BigInteger& b) const { return sum(b, 1); }
    BigInteger operator-(const BigInteger& b) const { return sum(b, -1); }

    BigInteger operator*(const BigInteger& b) const
    {
        BigInteger result;
        for (std::size_t i = 0; i < kLimbs; ++i)
            for (std::size_t j = 0; limb_[i] != 0 && i + j < kLimbs; ++j)
                result.limb_[i + j] += limb_[i] * b.limb_[j];
        result.carry();
        return result;
    }

    int sign() const
    {
        for (std::size_t k = kLimbs; k-- > 0;)
            if (limb_[k] != 0) return limb_[k] > 0 ? 1 : -1;
        return 0;
    }

  private:
    static constexpr std::size_t kLimbs = 40;
    static constexpr std::int64_t kBase = 1 << 24;

    BigInteger sum(const BigInteger& b, std::int64_t factor) const
    {
        BigInteger result;
        for (std::size_t k = 0; k < kLimbs; ++k) result.limb_[k] = limb_[k] + factor * b.limb_[k];
        result.carry();
        return result;
    }

    /// Makes every limb smaller than the base; the highest one that is not zero has the sign.
    void carry()
    {
        for (std::size_t k = 0; k + 1 < kLimbs; ++k) {
            const std::int64_t over = limb_[k] / kBase;
            limb_[k] -= over * kBase;
            limb_[k + 1] += over;
        }
    }

    std::array<std::int64_t, kLimbs> limb_{};
};

} // namespace firsthit::test
