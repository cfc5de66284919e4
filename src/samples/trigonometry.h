// trigonometry.h - sine and cosine with the same bits on every machine.
//
// Those of C libraries differ in their last bits. Here all is addition, multiplication and rounding to whole
// numbers, which IEEE 754 settles.
#pragma once

#include <cmath>

namespace firsthit {

/// Sine and cosine of one angle.
struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

/// For angles of at most a million; errors are below 1e-15.
inline SineCosine sine_cosine(double angle_rad)
{
    // pi / 2 in two parts, of which the first has 33 bits: its multiples are exact.
    constexpr double kHalfPi = 1.57079632673412561417, kHalfPiRest = 6.07710050650619224932e-11;
    const double quarters = std::floor(angle_rad / (kHalfPi + kHalfPiRest) + 0.5);
    const double x = (angle_rad - quarters * kHalfPi) - quarters * kHalfPiRest;

    // Taylor's series about 0, from its smallest term; x is at most pi / 4.
    const double x2 = x * x;
    double sine = 1, cosine = 1;
    for (int n = 18; n >= 2; n -= 2) {
        sine = 1 - sine * x2 / (n * (n + 1));
        cosine = 1 - cosine * x2 / (n * (n - 1));
    }
    sine *= x;
    switch (static_cast<long long>(quarters) & 3) {
    case 0:
        return {sine, cosine};
    case 1:
        return {cosine, -sine};
    case 2:
        return {-sine, -cosine};
    default:
        return {-cosine, sine};
    }
}

inline double sine(double angle_rad)
{
    return sine_cosine(angle_rad).sine;
}

inline double cosine(double angle_rad)
{
    return sine_cosine(angle_rad).cosine;
}

} // namespace firsthit
