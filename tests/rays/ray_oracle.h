// ray_oracle.h - what any ray hits, by a loop over all triangles in exact numbers: whole numbers for lattices, or
// rational numbers (GMP). It shares nothing with src/.
//
// A ray hits a triangle iff the signs of all three volumes d . ((a - o) x (b - o)) of its edges equal that of the
// volume of origin and triangle. A volume of an edge that is zero has the sign that it has for the direction
// d + (e, e^2, e^3) with a small e > 0. A ray without a direction hits nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace firsthit::test {

template <class Number>
using OracleVector = std::array<Number, 3>;

template <class Number>
using OracleTriangle = std::array<OracleVector<Number>, 3>;

template <class Number>
struct OracleRay {
    OracleVector<Number> origin, direction;
    std::optional<Number> first = {}, last = {}; // t_min and t_max
    std::uint32_t skip = 0xFFFFFFFF;
};

/// t = height / det; u and v are edge / det. det is positive.
template <class Number>
struct OracleHit {
    std::uint32_t triangle;
    Number height, det, edge1, edge2;
};

template <class Number>
int oracle_sign(const Number& x)
{
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

template <class Number>
OracleVector<Number> minus(const OracleVector<Number>& a, const OracleVector<Number>& b)
{
    return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
OracleVector<Number> oracle_cross(const OracleVector<Number>& a, const OracleVector<Number>& b)
{
    return {Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]),
        Number(a[0] * b[1] - a[1] * b[0])};
}

template <class Number>
Number oracle_dot(const OracleVector<Number>& a, const OracleVector<Number>& b)
{
    return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class Number>
std::optional<OracleHit<Number>> oracle_hit(
    const OracleRay<Number>& ray, const OracleTriangle<Number>& triangle, std::uint32_t id)
{
    if (id == ray.skip) return {};
    const OracleVector<Number> n =
        oracle_cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
    Number height = oracle_dot(n, minus(triangle[0], ray.origin));
    const int facing = oracle_sign(height);
    if (facing == 0) return {};
    std::array<Number, 3> edge;
    for (std::size_t k = 0; k < 3; ++k) {
        const OracleVector<Number> m =
            oracle_cross(minus(triangle[k], ray.origin), minus(triangle[(k + 1) % 3], ray.origin));
        edge[k] = oracle_dot(m, ray.direction);
        int sign = oracle_sign(edge[k]);
        for (std::size_t axis = 0; axis < 3 && sign == 0; ++axis) sign = oracle_sign(m[axis]);
        if (sign != facing) return {};
    }
    Number det = oracle_dot(n, ray.direction);
    if (facing < 0) {
        height = -height;
        det = -det;
        for (Number& e : edge) e = -e;
    }
    if (ray.first && height < Number(*ray.first * det)) return {};
    if (ray.last && height > Number(*ray.last * det)) return {};
    return OracleHit<Number>{id, height, det, edge[2], edge[0]};
}

/// All hits in the order of t, then of id.
template <class Number>
std::vector<OracleHit<Number>> oracle_hits(
    const OracleRay<Number>& ray, const std::vector<OracleTriangle<Number>>& triangles)
{
    std::vector<OracleHit<Number>> hits;
    if (ray.direction == OracleVector<Number>{0, 0, 0}) return hits;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
        const auto hit = oracle_hit(ray, triangles[id], id);
        if (!hit) continue;
        auto place = hits.end();
        while (place != hits.begin() &&
               Number(hit->height * (place - 1)->det) < Number((place - 1)->height * hit->det))
            --place;
        hits.insert(place, *hit);
    }
    return hits;
}

} // namespace firsthit::test
