// hit.cpp - exact predicates of hits where double precision is uncertain.
#include "exact/hit.h"

#include "exact/exact_volumes.h"

namespace firsthit {
namespace {

using glm::vec3;

/// 1/t = det / volume of a triangle in double precision, with bounds of the errors.
struct InverseDepth {
    double det, volume;             // absolute values
    double det_error, volume_error; // absolute
};

InverseDepth inverse_depth(const Corners& c, const vec3& d)
{
    const double e1x = double(c[1].x) - double(c[0].x), e1y = double(c[1].y) - double(c[0].y),
                 e1z = double(c[1].z) - double(c[0].z);
    const double e2x = double(c[2].x) - double(c[0].x), e2y = double(c[2].y) - double(c[0].y),
                 e2z = double(c[2].z) - double(c[0].z);
    const double dx = d.x, dy = d.y, dz = d.z;
    const double det = ((e1y * e2z - e1z * e2y) * dx + (e1z * e2x - e1x * e2z) * dy) +
                       (e1x * e2y - e1y * e2x) * dz;
    const double det_size = (std::abs(e1y * e2z) + std::abs(e1z * e2y)) * std::abs(dx) +
                            (std::abs(e1z * e2x) + std::abs(e1x * e2z)) * std::abs(dy) +
                            (std::abs(e1x * e2y) + std::abs(e1y * e2x)) * std::abs(dz);

    const auto n = cross_terms(c[1], c[2]);
    double volume = 0, volume_size = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double term =
            double(c[0][axis]) * (n[std::size_t(axis)].plus - n[std::size_t(axis)].minus);
        volume += term;
        volume_size += std::abs(term);
    }
    // Roundings of det: two differences, a product, a difference, a product, two sums. Of volume:
    // four.
    return {std::abs(det), std::abs(volume), 10 * kUlp * det_size, 8 * kUlp * volume_size};
}

/// An edge function in double precision, and a bound of its error.
struct PlainEdge {
    double value, error;
};

PlainEdge plain_edge(const vec3& a, const vec3& b, const vec3& d)
{
    const auto n = cross_terms(a, b);
    double term[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
        term[axis] = (n[axis].plus - n[axis].minus) * double(d[int(axis)]);
    // The error of each term is at most four roundings.
    return {(term[0] + term[1]) + term[2],
        8 * kUlp * (std::abs(term[0]) + std::abs(term[1]) + std::abs(term[2]))};
}

} // namespace

int exact_edge_sign(const vec3& a, const vec3& b, const vec3& d, bool displaced)
{
    Expansion<12> sum;
    add_volume(sum, a, b, d);
    if (sum.sign() != 0 || !displaced) return sum.sign();
    // The first component of a x b that is not zero decides (displacement). Both products are
    // exact.
    for (const Product2& n : cross_terms(a, b)) {
        if (n.plus > n.minus) return 1;
        if (n.plus < n.minus) return -1;
    }
    return 0;
}

int compare_depth_fast(const Corners& a, const Corners& b, const vec3& d)
{
    // a is nearer where det_a / volume_a > det_b / volume_b.
    const InverseDepth ia = inverse_depth(a, d), ib = inverse_depth(b, d);
    const double left = ia.det * ib.volume, right = ib.det * ia.volume;
    const double error = (ia.det_error * ib.volume + ia.det * ib.volume_error +
                             ib.det_error * ia.volume + ib.det * ia.volume_error +
                             ia.det_error * ib.volume_error + ib.det_error * ia.volume_error) *
                             (1 + 16 * kUlp) +
                         4 * kUlp * (left + right);
    if (left - right > error) return -1;
    if (right - left > error) return 1;
    return 0;
}

int compare_depth(const Corners& a, const Corners& b, const vec3& d, Effort& effort)
{
    if (const int certain = compare_depth_fast(a, b, d)) return certain;
    if (same_points(a, b)) return 0;

    ++effort.exact_calls;
    const auto det_a = determinant_expansion(a, d), det_b = determinant_expansion(b, d);
    const auto volume_a = volume_expansion(a), volume_b = volume_expansion(b);
    // Compressed, a determinant of floats within a few octaves has only two or three components.
    Expansion<2 * 2 * 36 * 12> sum;
    sum.add_product(det_a, volume_b, double(volume_b.sign() * det_a.sign()));
    sum.add_product(det_b, volume_a, -double(volume_a.sign() * det_b.sign()));
    return -sum.sign();
}

bool are_coplanar(const Corners& a, const Corners& b)
{
    if (same_points(a, b)) return true;
    for (const vec3& p : b) {
        Expansion<48> height; // N . p - N . v0, N . v0 = volume
        height.add(determinant_expansion(a, p));
        const auto base = volume_expansion(a);
        for (int i = 0; i < base.size(); ++i) height.add(-base[i]);
        if (height.sign() != 0) return false;
    }
    return true;
}

double hit_depth(const Corners& c, const vec3& d)
{
    const InverseDepth i = inverse_depth(c, d);
    return i.volume / i.det;
}

double exact_inverse_depth(const Corners& c, const vec3& d)
{
    return std::abs(determinant_expansion(c, d).estimate() / volume_expansion(c).estimate());
}

std::array<double, 2> exact_barycentrics(const Corners& c, const vec3& d)
{
    Expansion<12> opposite1, opposite2;
    add_volume(opposite1, c[2], c[0], d);
    add_volume(opposite2, c[0], c[1], d);
    const double det = determinant_expansion(c, d).estimate();
    return {opposite1.estimate() / det, opposite2.estimate() / det};
}

std::array<float, 2> rounded_barycentrics(const Corners& c, const vec3& d)
{
    const PlainEdge edge[3] = {
        plain_edge(c[1], c[2], d), plain_edge(c[2], c[0], d), plain_edge(c[0], c[1], d)};
    const double det = (edge[0].value + edge[1].value) + edge[2].value;
    double det_error = 0;
    for (const PlainEdge& e : edge) det_error += e.error + 4 * kUlp * std::abs(e.value);
    const bool certain = det_error <= 0.25 * std::abs(det);
    // Where both ends of an interval that holds the weight round to the same float, that is it. With
    // an error of det of a quarter at most, 2 stands for 1 / (1 - 1/4) and the roundings here.
    const auto rounded = [&](int k) {
        const double q = edge[k].value / det;
        const double error =
            2 * ((edge[k].error + std::abs(q) * det_error) / std::abs(det) + kUlp * std::abs(q));
        const float low = float(q - error), high = float(q + error);
        if (certain && low == high && low >= kLeastWeight) return low;
        Expansion<12> exact;
        add_volume(exact, c[std::size_t((k + 1) % 3)], c[std::size_t((k + 2) % 3)], d);
        return rounded_quotient(exact, determinant_expansion(c, d));
    };
    return {rounded(1), rounded(2)};
}

std::array<float, 2> rounded_parallel_barycentrics(const Corners& c, const vec3& d)
{
    // s = volume / det, and the weight of corner k is edge_k s_k / (det s).
    const double size = volume_expansion(c).estimate();
    const auto rounded = [&](std::size_t k) {
        Expansion<12> edge;
        add_volume(edge, c[(k + 1) % 3], c[(k + 2) % 3], d);
        const float w = float(edge.estimate() * double(c[k].z) / size);
        return w >= kLeastWeight ? w : 0.0f;
    };
    return {rounded(1), rounded(2)};
}

bool is_beyond(const Corners& c, const vec3& d, float nearest)
{
    // |volume| > nearest |det|. Both have a sign, and that of a hit's det is the volume's.
    const auto det = determinant_expansion(c, d);
    const auto size = volume_expansion(c);
    Expansion<12 + 2 * 36> ahead;
    ahead.add(size);
    ahead.add_scaled(det, -double(nearest));
    return ahead.sign() * size.sign() > 0;
}

} // namespace firsthit
