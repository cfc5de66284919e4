// careful_hit.cpp - hits of a triangle for which plain double arithmetic is not precise enough.
#include "exact/careful_hit.h"

#include "exact/expansion.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace firsthit {
namespace {

using glm::dvec3;
using glm::vec3;

/// |a.y b.z| + |a.z b.y|, ...: sizes that bound the rounding error of a x b.
dvec3 cross_size(const dvec3& a, const dvec3& b)
{
    return {std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
        std::abs(a.x * b.y) + std::abs(a.y * b.x)};
}

/// A sum, and the sum of the sizes of its terms.
struct Sum {
    double value, size;

    bool is_precise() const { return size <= kMostLost * std::abs(value); } // NaN: false
};

Sum dot(const dvec3& a, const dvec3& b)
{
    const dvec3 term = a * b;
    return {(term.x + term.y) + term.z, (std::abs(term.x) + std::abs(term.y)) + std::abs(term.z)};
}

/// Component `axis` of (v1 - v0) x (v2 - v0), by an expansion of exact products.
double exact_normal(const Corners& c, int axis)
{
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    Expansion<6> sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const vec3 &a = c[k], &b = c[(k + 1) % 3];
        sum.add(double(a[y]) * double(b[z]));
        sum.add(-(double(a[z]) * double(b[y])));
    }
    sum.compress();
    return sum.estimate();
}

double exact_volume(const Corners& c)
{
    Expansion<12> sum;
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        sum.add_product(double(c[1][y]) * double(c[2][z]), double(c[0][x]));
        sum.add_product(double(c[1][z]) * double(c[2][y]), -double(c[0][x]));
    }
    sum.compress();
    return sum.estimate();
}

} // namespace

CarefulHit::CarefulHit(const Corners& corners) : corners_(corners)
{
    const dvec3 v0(corners[0]), v1(corners[1]), v2(corners[2]);
    edge1_ = glm::cross(v2, v0);
    edge2_ = glm::cross(v0, v1);
    plain_n_ = glm::cross(v1 - v0, v2 - v0);
    plain_n_size_ = cross_size(v1 - v0, v2 - v0);
    plain_volume_ = dot(v0, glm::cross(v1, v2)).is_precise();
    n_ = {exact_normal(corners, 0), exact_normal(corners, 1), exact_normal(corners, 2)};
    volume_ = exact_volume(corners);
}

CarefulHit::Plain CarefulHit::plain(const vec3& d) const
{
    // Roundings of a term: the differences of corners, their product, the difference of products,
    // the product with d, two sums.
    const dvec3 ray(d);
    const Sum det{dot(plain_n_, ray).value, dot(plain_n_size_, glm::abs(ray)).value};
    if (!det.is_precise()) return {};
    const auto is_small = [&](const Sum& edge) { return Sum{det.value, edge.size}.is_precise(); };
    return {plain_volume_, is_small(dot(edge1_, ray)) && is_small(dot(edge2_, ray))};
}

double CarefulHit::depth(const vec3& d) const
{
    const Sum det = dot(n_, dvec3(d));
    return det.is_precise() ? volume_ / det.value : 1 / exact_inverse_depth(corners_, d);
}

std::array<double, 2> CarefulHit::weights(const vec3& d) const
{
    const dvec3 ray(d);
    const Sum det = dot(n_, ray), u = dot(edge1_, ray), v = dot(edge2_, ray);
    if (!det.is_precise() || !u.is_precise() || !v.is_precise())
        return exact_barycentrics(corners_, d);
    return {u.value / det.value, v.value / det.value};
}

} // namespace firsthit
