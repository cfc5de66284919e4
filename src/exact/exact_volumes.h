// exact_volumes.h - volumes of float corners as expansions, and quotients of them rounded once.
#pragma once

#include "exact/expansion.h"
#include "exact/hit.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

namespace firsthit {

struct Product2 {
    double plus, minus; // the value is plus - minus; both are exact products of two floats
};

/// The components of a x b, as differences of exact products.
inline std::array<Product2, 3> cross_terms(const glm::vec3& a, const glm::vec3& b)
{
    return {{{double(a.y) * double(b.z), double(a.z) * double(b.y)},
        {double(a.z) * double(b.x), double(a.x) * double(b.z)},
        {double(a.x) * double(b.y), double(a.y) * double(b.x)}}};
}

/// Adds d . (a x b): six products of an exact product and a float, of two components each.
template <int N>
void add_volume(Expansion<N>& sum, const glm::vec3& a, const glm::vec3& b, const glm::vec3& d)
{
    const auto n = cross_terms(a, b);
    for (int axis = 0; axis < 3; ++axis) {
        sum.add_product(n[std::size_t(axis)].plus, double(d[axis]));
        sum.add_product(n[std::size_t(axis)].minus, -double(d[axis]));
    }
}

/// v0 . (v1 x v2)
inline Expansion<12> volume_expansion(const Corners& c)
{
    Expansion<12> sum;
    add_volume(sum, c[1], c[2], c[0]);
    sum.compress();
    return sum;
}

/// N . d with N = (v1 - v0) x (v2 - v0), which equals the sum of the three edge functions.
inline Expansion<36> determinant_expansion(const Corners& c, const glm::vec3& d)
{
    Expansion<36> sum;
    add_volume(sum, c[0], c[1], d);
    add_volume(sum, c[1], c[2], d);
    add_volume(sum, c[2], c[0], d);
    sum.compress();
    return sum;
}

/// Below this, a rounded quotient is 0.
inline constexpr float kLeastWeight = 0x1p-126f;

/// The float nearest to value / det, which is not negative: ties to even, 0 below 2^-126, infinite beyond the
/// largest float.
template <int N>
float rounded_quotient(const Expansion<N>& value, const Expansion<36>& det)
{
    const double q = value.estimate() / det.estimate();
    if (!(q >= double(kLeastWeight))) return 0;
    if (!(q * (1 + 0x1p-40) < 0x1.ffffffp127)) return std::numeric_limits<float>::infinity();
    // The quotient is between these floats, which are equal or neighbours.
    const float low = float(q * (1 - 0x1p-40)), high = float(q * (1 + 0x1p-40));
    if (low == high) return low;
    const double middle = 0.5 * (double(low) + double(high)); // exact
    Expansion<N + 2 * 36> above;
    above.add(value);
    above.add_scaled(det, -middle);
    const int side = above.sign() * det.sign();
    return side > 0 ? high : side < 0 ? low : float(middle);
}

/// Whether both triangles have the same three points, in any order.
inline bool same_points(Corners a, Corners b)
{
    const auto less = [](const glm::vec3& p, const glm::vec3& q) {
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    std::sort(a.begin(), a.end(), less);
    std::sort(b.begin(), b.end(), less);
    return a == b;
}

} // namespace firsthit
