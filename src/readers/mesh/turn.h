// turn.h - which way three points of a plane turn, exactly.
#pragma once

#include "exact/expansion.h"

#include <glm/vec2.hpp>

#include <cmath>

namespace firsthit {

/// The sign of the area of the triangle a, b, c: 1 counter-clockwise, -1 clockwise, 0 on one line.
/// Exact, if each coordinate is a finite float.
///
/// source  the bound of the filter is `ccwerrboundA` of Shewchuk 1997, "Adaptive Precision
///         Floating-Point Arithmetic and Fast Robust Geometric Predicates"
inline int turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    constexpr double kBound = (3 + 16 * 0x1p-53) * 0x1p-53;
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double area = left - right;
    const double error = kBound * (std::abs(left) + std::abs(right));
    if (area > error) return 1;
    if (area < -error) return -1;

    // Most differences are exact, and then only the products are rounded.
    const auto exact = [](double p, double q) { return two_sum(p, -q).low == 0; };
    if (exact(b.x, a.x) && exact(c.y, a.y) && exact(b.y, a.y) && exact(c.x, a.x)) {
        if (left != right) return left > right ? 1 : -1;
        const double left_rest = std::fma(b.x - a.x, c.y - a.y, -left);
        const double right_rest = std::fma(b.y - a.y, c.x - a.x, -right);
        return left_rest > right_rest ? 1 : left_rest < right_rest ? -1 : 0;
    }

    // Products of two floats are exact in double.
    Expansion<6> sum;
    sum.add(a.x * b.y);
    sum.add(-(a.y * b.x));
    sum.add(b.x * c.y);
    sum.add(-(b.y * c.x));
    sum.add(c.x * a.y);
    sum.add(-(c.y * a.x));
    return sum.sign();
}

} // namespace firsthit
