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
};

/// a . (b x c) of vectors whose coordinates have at most one rounding. A term has eight roundings: three of the
/// vectors, a product, a difference, a product, two sums. Nothing under- or overflows: the coordinates are
/// multiples of 2^-149 below 2^130.
Bounded bounded_volume(const dvec3& a, const dvec3& b, const dvec3& c)
{
    const double xy = b.x * c.y, yx = b.y * c.x, yz = b.y * c.z, zy = b.z * c.y, zx = b.z * c.x,
                 xz = b.x * c.z;
    const double size = (std::abs(a.x) * (std::abs(yz) + std::abs(zy)) +
                            std::abs(a.y) * (std::abs(zx) + std::abs(xz))) +
                        std::abs(a.z) * (std::abs(xy) + std::abs(yx));
    return {(a.x * (yz - zy) + a.y * (zx - xz)) + a.z * (xy - yx), 10 * kUlp * size};
}

dvec3 difference(const vec3& a, const vec3& b)
{
    return dvec3(a) - dvec3(b);
}

Bounded bounded_edge(const Ray& ray, const vec3& a, const vec3& b)
{
    return bounded_volume(dvec3(ray.direction), difference(a, ray.origin), difference(b, a));
}

Bounded bounded_determinant(const Ray& ray, const Corners& c)
{
    return bounded_volume(dvec3(ray.direction), difference(c[1], c[0]), difference(c[2], c[0]));
}

Bounded bounded_volume(const Ray& ray, const Corners& c)
{
    return bounded_volume(
        difference(c[0], ray.origin), difference(c[1], c[0]), difference(c[2], c[0]));
}

/// edge(a, b): (a - o) x (b - o) = a x b + b x o + o x a.
Expansion<36> exact_edge(const Ray& ray, const vec3& a, const vec3& b)
{
    return exact_determinant({a, b, ray.origin}, ray.direction);
}

/// (v0 - o) . N
Expansion<48> exact_volume(const Ray& ray, const Corners& c)
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
        if (const int sign = exact_determinant({a, b, ray.origin}, axis).sign()) return sign;
    return 0;
}

int volume_sign(const Ray& ray, const Corners& c, Effort& effort)
{
    if (const int sign = bounded_volume(ray, c).sign()) return sign;
    ++effort.exact_calls;
    return exact_volume(ray, c).sign();
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

/// A triangle's n = e1 x e2 from corner 0, with what bounds the error of its products.
struct PlainNormal {
    dvec3 e1, e2, n, size;

    explicit PlainNormal(const Corners& c) : e1(difference(c[1], c[0])), e2(difference(c[2], c[0]))
    {
        const dvec3 plus(e1.y * e2.z, e1.z * e2.x, e1.x * e2.y),
            minus(e1.z * e2.y, e1.x * e2.z, e1.y * e2.x);
        n = plus - minus;
        size = glm::abs(plus) + glm::abs(minus);
    }

    /// a . n, as bounded_volume has it.
    Bounded along(const dvec3& a) const
    {
        return {(a.x * n.x + a.y * n.y) + a.z * n.z,
            10 * kUlp *
                ((std::abs(a.x) * size.x + std::abs(a.y) * size.y) + std::abs(a.z) * size.z)};
    }

    /// The unit normal, within a few units in the last place of float.
    vec3 unit(const Corners& c) const
    {
        dvec3 m = n;
        if (largest_size(n) < 0x1p-24 * largest_size(e1) * largest_size(e2)) { // digits cancel
            const auto exact = [&](const vec3& axis) {
                return exact_determinant(c, axis).estimate();
            };
            m = {exact({1, 0, 0}), exact({0, 1, 0}), exact({0, 0, 1})};
        }
        return vec3(m * (1 / std::sqrt(glm::dot(m, m)))); // squares are from 2^-596 to 2^404
    }
};

/// Weights of corners 1 and 2, each NaN where double precision does not know it.
std::array<float, 2> certain_weights(
    const Ray& ray, const Corners& c, const CertainQuotients& quotient)
{
    return {quotient(bounded_edge(ray, c[2], c[0])), quotient(bounded_edge(ray, c[0], c[1]))};
}

std::array<float, 2> with_exact_weights(
    const Ray& ray, const Corners& c, std::array<float, 2> certain)
{
    for (std::size_t k = 0; k < 2; ++k)
        if (certain[k] != certain[k])
            certain[k] = rounded_quotient(exact_edge(ray, c[k == 0 ? 2 : 0], c[k == 0 ? 0 : 1]),
                exact_determinant(c, ray.direction));
    return certain;
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
    const auto det_a = exact_determinant(a, ray.direction),
               det_b = exact_determinant(b, ray.direction);
    const auto volume_a = exact_volume(ray, a), volume_b = exact_volume(ray, b);
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
    const auto det = exact_determinant(c, ray.direction);
    const auto volume = exact_volume(ray, c);
    Expansion<48 + 2 * 36> sum; // |volume| - t |det|
    for (int i = 0; i < volume.size(); ++i) sum.add(volume.sign() * volume[i]);
    sum.add_scaled(det, -double(t) * det.sign());
    return sum.sign();
}

DepthInterval depth_interval(const Ray& ray, const Corners& c)
{
    const Bounded det = bounded_determinant(ray, c), volume = bounded_volume(ray, c);
    const double size = std::abs(det.value), height = std::abs(volume.value);
    if (!(det.error < 0.5 * size)) return {0, std::numeric_limits<double>::infinity()};
    constexpr double kSlack = 8 * kUlp;
    return {std::max(0.0, (height - volume.error) / (size + det.error) * (1 - kSlack)),
        (height + volume.error) / (size - det.error) * (1 + kSlack)};
}

std::array<float, 2> rounded_barycentrics(const Ray& ray, const Corners& c)
{
    const CertainQuotients quotient(bounded_determinant(ray, c));
    return with_exact_weights(ray, c, certain_weights(ray, c, quotient));
}

RayHit rounded_hit(const Ray& ray, const Corners& c)
{
    const PlainNormal normal(c);
    const CertainQuotients quotient(normal.along(dvec3(ray.direction)));
    RayHit hit;
    hit.t = quotient(normal.along(difference(c[0], ray.origin)));
    if (hit.t != hit.t)
        hit.t = rounded_quotient(exact_volume(ray, c), exact_determinant(c, ray.direction));
    const auto [u, v] = with_exact_weights(ray, c, certain_weights(ray, c, quotient));
    hit.u = u;
    hit.v = v;
    hit.normal = normal.unit(c);
    return hit;
}

} // namespace firsthit
