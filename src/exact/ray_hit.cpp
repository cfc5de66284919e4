// ray_hit.cpp - exact predicates of any ray: filters in double, and expansions where these are not certain.
#include "exact/ray_hit.h"

#include "exact/exact_volumes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace firsthit {
namespace {

using glm::dvec3;
using glm::vec3;

/// A sum of products in double precision, and a bound of its error.
struct Bounded {
    double value, error;

    int sign() const { return value > error ? 1 : value < -error ? -1 : 0; } // 0: not certain
    Bounded operator-() const { return {-value, error}; }
};

/// b x c in double precision, with the sizes of its products. Coordinates of b and c have at most one rounding.
struct PlainCross {
    dvec3 n, size;

    PlainCross(const dvec3& b, const dvec3& c)
    {
        const dvec3 plus(b.y * c.z, b.z * c.x, b.x * c.y), minus(b.z * c.y, b.x * c.z, b.y * c.x);
        n = plus - minus;
        size = glm::abs(plus) + glm::abs(minus);
    }

    /// a . (b x c), where coordinates of a have at most one rounding too. A term has eight roundings: three of the
    /// vectors, a product, a difference, a product, two sums. Nothing under- or overflows: the coordinates are
    /// multiples of 2^-149 below 2^130.
    Bounded along(const dvec3& a) const
    {
        return {(a.x * n.x + a.y * n.y) + a.z * n.z,
            10 * kUlp *
                ((std::abs(a.x) * size.x + std::abs(a.y) * size.y) + std::abs(a.z) * size.z)};
    }
};

dvec3 difference(const vec3& a, const vec3& b)
{
    return dvec3(a) - dvec3(b);
}

Bounded bounded_edge(const Ray& ray, const vec3& a, const vec3& b)
{
    return PlainCross(difference(a, ray.origin), difference(b, a)).along(dvec3(ray.direction));
}

/// N = (v1 - v0) x (v2 - v0)
PlainCross plain_normal(const Corners& c)
{
    return {difference(c[1], c[0]), difference(c[2], c[0])};
}

/// edge(a, b): (a - o) x (b - o) = a x b + b x o + o x a.
Expansion<36> exact_edge(const Ray& ray, const vec3& a, const vec3& b)
{
    return determinant_expansion({a, b, ray.origin}, ray.direction);
}

/// (v0 - o) . N
Expansion<48> volume_expansion(const Ray& ray, const Corners& c)
{
    const vec3 back = -ray.origin;
    Expansion<48> sum;
    add_volume(sum, c[1], c[2], c[0]);
    add_volume(sum, c[0], c[1], back);
    add_volume(sum, c[1], c[2], back);
    add_volume(sum, c[2], c[0], back);
    sum.compress();
    return sum;
}

int exact_edge_sign(const Ray& ray, const vec3& a, const vec3& b)
{
    if (const int sign = exact_edge(ray, a, b).sign()) return sign;
    // The first component of (a - o) x (b - o) that is not zero decides (displacement).
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)})
        if (const int sign = determinant_expansion({a, b, ray.origin}, axis).sign()) return sign;
    return 0;
}

int volume_sign(const Ray& ray, const Corners& c, Effort& effort)
{
    if (const int sign = plain_normal(c).along(difference(c[0], ray.origin)).sign()) return sign;
    ++effort.exact_calls;
    return volume_expansion(ray, c).sign();
}

/// The floats nearest to quotients of one determinant, where double precision knows them.
class CertainQuotients {
  public:
    explicit CertainQuotients(const Bounded& det)
        : inverse_(1 / det.value),
          det_error_(det.error),
          is_good_(det.error <= 0.25 * std::abs(det.value))
    {
    }

    /// value / det; NaN if it is not certain.
    float operator()(const Bounded& value) const
    {
        constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
        // With an error of a quarter of det at most, 2 stands for 1 / (1 - 1/4) and the roundings here.
        const double q = value.value * inverse_, size = std::abs(q);
        const double error =
            2 * ((value.error + size * det_error_) * std::abs(inverse_) + 2 * kUlp * size);
        if (!is_good_ || !(q + error < double(std::numeric_limits<float>::max()))) return kUnknown;
        const float low = float(q - error), high = float(q + error);
        return low == high && low >= kLeastWeight ? low : kUnknown;
    }

  private:
    double inverse_, det_error_;
    bool is_good_;
};

double largest_size(const dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The unit normal of the corners' order, within a few units in the last place of float.
vec3 unit_normal(const Corners& c, const PlainCross& plain)
{
    dvec3 n = plain.n;
    if (largest_size(n) < 0x1p-24 * largest_size(plain.size)) { // digits cancel
        const auto exact = [&](const vec3& axis) {
            return determinant_expansion(c, axis).estimate();
        };
        n = {exact({1, 0, 0}), exact({0, 1, 0}), exact({0, 0, 1})};
    }
    return vec3(n * (1 / std::sqrt(glm::dot(n, n)))); // squares are from 2^-596 to 2^404
}

/// u and v of a hit, each rounded once.
std::array<float, 2> weights(const Ray& ray, const Corners& c, const CertainQuotients& quotient)
{
    // edge(v0, v1) = d . (p x e1) = e1 . (d x p) with p = v0 - o, and edge(v2, v0) = -e2 . (d x p).
    const PlainCross r(dvec3(ray.direction), difference(c[0], ray.origin));
    std::array<float, 2> uv = {
        quotient(-r.along(difference(c[2], c[0]))), quotient(r.along(difference(c[1], c[0])))};
    if (uv[0] != uv[0])
        uv[0] =
            rounded_quotient(exact_edge(ray, c[2], c[0]), determinant_expansion(c, ray.direction));
    if (uv[1] != uv[1])
        uv[1] =
            rounded_quotient(exact_edge(ray, c[0], c[1]), determinant_expansion(c, ray.direction));
    return uv;
}

} // namespace

bool usable(const Ray& ray)
{
    const vec3& d = ray.direction;
    return usable(ray.origin) && std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z) &&
           d != vec3(0) && ray.t_min <= ray.t_max;
}

int edge_sign(const Ray& ray, const vec3& a, const vec3& b, Effort& effort)
{
    if (const int sign = bounded_edge(ray, a, b).sign()) return sign;
    ++effort.exact_calls;
    return exact_edge_sign(ray, a, b);
}

bool is_hit(const Ray& ray, const Corners& c, Effort& effort)
{
    if (!usable(c)) return false;
    // Most triangles are missed, and most of these certainly: ask that first.
    const Bounded edge[3] = {bounded_edge(ray, c[0], c[1]), bounded_edge(ray, c[1], c[2]),
        bounded_edge(ray, c[2], c[0])};
    int sign[3];
    bool above = false, below = false;
    for (int k = 0; k < 3; ++k) {
        sign[k] = edge[k].sign();
        above |= sign[k] > 0;
        below |= sign[k] < 0;
    }
    if (above && below) return false;
    const int facing = volume_sign(ray, c, effort);
    if (facing == 0 || (facing < 0 ? above : below)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        if (sign[k] == facing) continue;
        ++effort.exact_calls;
        if (exact_edge_sign(ray, c[k], c[(k + 1) % 3]) != facing) return false;
    }
    return true;
}

int compare_depth(const Ray& ray, const Corners& a, const Corners& b, Effort& effort)
{
    const DepthInterval ta = depth_interval(ray, a), tb = depth_interval(ray, b);
    if (ta.high < tb.low) return -1;
    if (tb.high < ta.low) return 1;
    if (same_points(a, b)) return 0;

    ++effort.exact_calls;
    const auto det_a = determinant_expansion(a, ray.direction),
               det_b = determinant_expansion(b, ray.direction);
    const auto volume_a = volume_expansion(ray, a), volume_b = volume_expansion(ray, b);
    Expansion<2 * 2 * 36 * 48> sum; // |volume_a| |det_b| - |volume_b| |det_a|
    sum.add_product(det_b, volume_a, double(volume_a.sign() * det_b.sign()));
    sum.add_product(det_a, volume_b, -double(volume_b.sign() * det_a.sign()));
    return sum.sign();
}

int compare_depth(const Ray& ray, const Corners& c, float t, Effort& effort)
{
    if (t <= 0) return 1;
    const DepthInterval own = depth_interval(ray, c);
    if (own.high < double(t) || std::isinf(t)) return -1;
    if (own.low > double(t)) return 1;
    ++effort.exact_calls;
    const auto det = determinant_expansion(c, ray.direction);
    const auto volume = volume_expansion(ray, c);
    Expansion<48 + 2 * 36> sum; // |volume| - t |det|
    for (int i = 0; i < volume.size(); ++i) sum.add(volume.sign() * volume[i]);
    sum.add_scaled(det, -double(t) * det.sign());
    return sum.sign();
}

DepthInterval depth_interval(const Ray& ray, const Corners& c)
{
    const PlainCross normal = plain_normal(c);
    const Bounded det = normal.along(dvec3(ray.direction)),
                  volume = normal.along(difference(c[0], ray.origin));
    const double size = std::abs(det.value), height = std::abs(volume.value);
    if (!(det.error < 0.5 * size)) return {0, std::numeric_limits<double>::infinity()};
    constexpr double kSlack = 8 * kUlp;
    return {std::max(0.0, (height - volume.error) / (size + det.error) * (1 - kSlack)),
        (height + volume.error) / (size - det.error) * (1 + kSlack)};
}

std::array<float, 2> rounded_barycentrics(const Ray& ray, const Corners& c)
{
    return weights(ray, c, CertainQuotients(plain_normal(c).along(dvec3(ray.direction))));
}

RayHit rounded_hit(const Ray& ray, const Corners& c)
{
    const PlainCross normal = plain_normal(c);
    const CertainQuotients quotient(normal.along(dvec3(ray.direction)));
    RayHit hit;
    hit.t = quotient(normal.along(difference(c[0], ray.origin)));
    if (hit.t != hit.t)
        hit.t = rounded_quotient(volume_expansion(ray, c), determinant_expansion(c, ray.direction));
    const auto [u, v] = weights(ray, c, quotient);
    hit.u = u;
    hit.v = v;
    hit.normal = unit_normal(c, normal);
    return hit;
}

} // namespace firsthit
