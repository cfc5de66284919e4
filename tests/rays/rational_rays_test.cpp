// rational_rays_test.cpp - rays and triangles of all sizes and places hit what rational numbers say.
#include "random_numbers.h"
#include "rays/cast_answers_of.h"
#include "rays/ray_oracle.h"

#include <gtest/gtest.h>

#include <gmpxx.h>

#include <cmath>
#include <functional>

namespace firsthit::test {
namespace {

using glm::vec3;

mpq_class rational(float x)
{
    return mpq_class(double(x));
}

OracleVector<mpq_class> rational(const vec3& v)
{
    return {rational(v.x), rational(v.y), rational(v.z)};
}

/// Whether no float is nearer to the exact value, which is not negative: 0 stands for all below 2^-126.
bool is_nearest_float(float x, const mpq_class& exact)
{
    const mpq_class least(0x1p-126);
    if (x == 0) return exact < least;
    if (std::isinf(x)) return exact > mpq_class(0x1.fffffep127);
    const float below = std::nextafter(x, 0.0f), above = std::nextafter(x, 2 * x);
    const mpq_class low = (rational(x) + rational(below)) / 2;
    if (exact < low) return false;
    return std::isinf(above) || exact <= (rational(x) + rational(above)) / 2;
}

struct RationalCase {
    std::vector<vec3> position;
    std::vector<Ray> rays;
};

std::vector<glm::uvec3> separate_triangles(std::size_t corners)
{
    std::vector<glm::uvec3> index;
    for (unsigned k = 0; k + 2 < corners; k += 3) index.push_back({k, k + 1, k + 2});
    return index;
}

void expect_right(const RationalCase& given)
{
    const std::vector<glm::uvec3> index = separate_triangles(given.position.size());
    const CastMesh mesh(given.position, index);
    std::vector<OracleTriangle<mpq_class>> triangles;
    for (const glm::uvec3& t : index)
        triangles.push_back({rational(given.position[t.x]), rational(given.position[t.y]),
            rational(given.position[t.z])});
    const auto oracle = [&](std::size_t k) {
        const Ray& ray = given.rays[k];
        OracleRay<mpq_class> of_oracle{rational(ray.origin), rational(ray.direction)};
        of_oracle.first = rational(ray.t_min);
        if (!std::isinf(ray.t_max)) of_oracle.last = rational(ray.t_max);
        of_oracle.skip = ray.skip;
        return oracle_hits(of_oracle, triangles);
    };
    const auto same = [&](const RayHit& hit, const OracleHit<mpq_class>& of_oracle, std::size_t) {
        return is_nearest_float(hit.t, of_oracle.height / of_oracle.det) &&
               is_nearest_float(hit.u, of_oracle.edge1 / of_oracle.det) &&
               is_nearest_float(hit.v, of_oracle.edge2 / of_oracle.det);
    };
    EXPECT_EQ(count_wrong(mesh.cast(given.rays), given.rays.size(), oracle, same), 0U);
}

vec3 draw(std::mt19937& random, float size)
{
    return {
        uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// Numbers whose exponents are anywhere between two.
float draw_wide(std::mt19937& random, int low, int high)
{
    return std::ldexp(uniform(random, -1, 1), whole(random, low, high));
}
vec3 draw_wide_vector(std::mt19937& random, int low, int high)
{
    return {
        draw_wide(random, low, high), draw_wide(random, low, high), draw_wide(random, low, high)};
}

/// Rays towards points of edges and corners of the triangles, rounded; with directions of all lengths.
std::vector<Ray> rays_at_edges(const std::vector<vec3>& position, float size, std::mt19937& random)
{
    std::vector<Ray> rays;
    for (int k = 0; k < 700; ++k) {
        const std::size_t t = 3 * std::size_t(whole(random, 0, int(position.size() / 3) - 1));
        const vec3 a = position[t], b = position[t + 1], c = position[t + 2];
        const float w = uniform(random, 0, 1);
        const vec3 aim = whole(random, 0, 3) == 0 ? a
                         : whole(random, 0, 2) == 0
                             ? 0.5f * a + (0.5f * w) * b + (0.5f - 0.5f * w) * c
                             : w * a + (1 - w) * b;
        const vec3 from = whole(random, 0, 5) == 0 ? b : draw(random, 2 * size);
        Ray ray{from, aim - from};
        const float largest = std::max({std::abs(ray.direction.x), std::abs(ray.direction.y),
            std::abs(ray.direction.z), 1e-37f});
        if (whole(random, 0, 2) == 0)
            ray.direction = std::ldexp(1.0f, whole(random, -140, 120)) * (ray.direction / largest);
        if (whole(random, 0, 9) == 0) ray.t_max = uniform(random, 0, 2);
        if (whole(random, 0, 9) == 0) ray.t_min = uniform(random, 0, 2);
        if (whole(random, 0, 9) == 0) ray.skip = unsigned(t / 3);
        rays.push_back(ray);
    }
    return rays;
}

TEST(RationalRays, OfAllScales)
{
    for (const float size : {1e-30f, 1e-18f, 1e-6f, 1.0f, 1e6f, 1e12f, 9e28f}) {
        SCOPED_TRACE(size);
        std::mt19937 random(3);
        RationalCase made;
        for (int k = 0; k < 3 * 24; ++k) made.position.push_back(draw(random, size));
        made.rays = rays_at_edges(made.position, size, random);
        expect_right(made);
    }
}

TEST(RationalRays, OfNumbersOfAllSizes)
{
    for (const auto& [low, high] : {std::pair(-149, 96), std::pair(-20, 20), std::pair(-60, 40)}) {
        SCOPED_TRACE(low);
        std::mt19937 random(4);
        RationalCase made;
        for (int k = 0; k < 3 * 24; ++k)
            made.position.push_back(draw_wide_vector(random, low, high));
        for (int k = 0; k < 1500; ++k)
            made.rays.push_back({draw_wide_vector(random, low, high),
                draw_wide_vector(random, whole(random, 0, 1) ? -149 : -20, 126)});
        expect_right(made);
    }
}

/// Needles: two corners a few units in the last place apart, and almost flat triangles around one point.
TEST(RationalRays, OfNeedles)
{
    std::mt19937 random(5);
    RationalCase made;
    for (int k = 0; k < 12; ++k) {
        const vec3 a = draw(random, 1);
        made.position.insert(made.position.end(),
            {vec3(0.1f, 0.2f, 0.3f), a,
                vec3(std::nextafter(a.x, 2.0f), a.y, std::nextafter(a.z, 2.0f))});
        const vec3 b = draw(random, 1);
        made.position.insert(made.position.end(),
            {b, 3.0f * b, vec3(2.0f * b.x, 2.0f * b.y, std::nextafter(2.0f * b.z, 9.0f))});
    }
    made.rays = rays_at_edges(made.position, 1, random);
    expect_right(made);
}

/// Rays almost along an axis, past boxes that are flat in it and far away.
TEST(RationalRays, AlmostAlongAnAxis)
{
    std::mt19937 random(6);
    RationalCase made;
    for (int k = 0; k < 30; ++k) {
        const float x = whole(random, 0, 1) ? 0.0f : draw_wide(random, -149, -100);
        const float z = draw_wide(random, -10, 95);
        for (int corner = 0; corner < 3; ++corner)
            made.position.push_back({x, draw_wide(random, -149, 10), z * uniform(random, 0.5f, 1)});
    }
    for (int k = 0; k < 2000; ++k) {
        const float tiny = whole(random, 0, 2) ? draw_wide(random, -149, -60) : -0.0f;
        made.rays.push_back({{draw_wide(random, -149, -100), draw_wide(random, -149, 3),
                                 draw_wide(random, -149, 10)},
            {tiny, draw_wide(random, -149, -20), uniform(random, -1, 1)}});
    }
    expect_right(made);
}

} // namespace
} // namespace firsthit::test
