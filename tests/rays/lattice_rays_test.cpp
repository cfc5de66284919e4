// lattice_rays_test.cpp - rays of a lattice hit what whole numbers say, at all scales, with the same bits on every
// instruction set.
#include "instruction_sets.h"
#include "rays/cast_answers_of.h"
#include "rays/lattice_meshes.h"
#include "rays/ray_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace firsthit::test {
namespace {

/// Coordinates are whole numbers times 2^space, directions times 2^direction: t is times 2^(space - direction).
struct LatticeScale {
    int space, direction;
};
constexpr LatticeScale kScales[] = {
    {0, 0}, {-100, -100}, {93, 93}, {0, -149}, {0, 120}, {93, -20}, {-140, -3}, {3, -40}};

glm::vec3 scaled(const glm::ivec3& v, int exponent)
{
    return {std::ldexp(float(v.x), exponent), std::ldexp(float(v.y), exponent),
        std::ldexp(float(v.z), exponent)};
}

OracleVector<std::int64_t> whole_vector(const glm::ivec3& v)
{
    return {v.x, v.y, v.z};
}

/// The float nearest to a quotient of small whole numbers times a power of two: 0 below 2^-126.
float quotient(std::int64_t value, std::int64_t det, int exponent)
{
    const double q = std::ldexp(double(value) / double(det), exponent);
    if (q < 0x1p-126) return 0;
    return q > 0x1.fffffep127 ? std::numeric_limits<float>::infinity() : float(q);
}

struct LatticeCase {
    std::vector<Ray> ray;
    std::vector<OracleRay<std::int64_t>> of_oracle; // t_min and t_max times 4
};

LatticeCase make_case(
    const LatticeMesh& mesh, std::size_t rays, LatticeScale scale, std::mt19937& random)
{
    LatticeCase made;
    for (const LatticeRay& r : lattice_rays(mesh, rays, random)) {
        Ray ray{scaled(r.origin, scale.space), scaled(r.direction, scale.direction)};
        OracleRay<std::int64_t> of_oracle{whole_vector(r.origin), whole_vector(r.direction)};
        if (whole(random, 0, 3) == 0) {
            ray.skip = unsigned(whole(random, 0, int(mesh.triangle.size()) - 1));
            of_oracle.skip = ray.skip;
        }
        const int exponent = scale.space - scale.direction;
        if (whole(random, 0, 3) == 0 && std::abs(exponent) < 100) {
            const int first = whole(random, -1, 8), last = first + whole(random, 0, 8);
            ray.t_min = std::ldexp(float(first), exponent - 2);
            ray.t_max = std::ldexp(float(last), exponent - 2);
            of_oracle.first = first;
            of_oracle.last = last;
        }
        made.ray.push_back(ray);
        made.of_oracle.push_back(of_oracle);
    }
    return made;
}

/// The oracle's hits. t_min and t_max are quarters, so heights are times 4.
std::vector<OracleHit<std::int64_t>> hits_of(
    const OracleRay<std::int64_t>& ray, const std::vector<OracleTriangle<std::int64_t>>& triangles)
{
    OracleRay<std::int64_t> without = ray;
    without.first.reset();
    without.last.reset();
    std::vector<OracleHit<std::int64_t>> hits = oracle_hits(without, triangles);
    std::erase_if(hits, [&](const OracleHit<std::int64_t>& hit) {
        return (ray.first && 4 * hit.height < *ray.first * hit.det) ||
               (ray.last && 4 * hit.height > *ray.last * hit.det);
    });
    return hits;
}

std::size_t wrong_rays(
    const LatticeMesh& lattice, LatticeScale scale, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<glm::vec3> position;
    for (const glm::ivec3& p : lattice.corner) position.push_back(scaled(p, scale.space));
    std::vector<OracleTriangle<std::int64_t>> triangles;
    for (const glm::uvec3& t : lattice.triangle)
        triangles.push_back({whole_vector(lattice.corner[t.x]), whole_vector(lattice.corner[t.y]),
            whole_vector(lattice.corner[t.z])});
    const CastMesh mesh(position, lattice.triangle);
    const LatticeCase rays = make_case(lattice, count, scale, random);
    const int exponent = scale.space - scale.direction;
    return count_wrong(
        mesh.cast(rays.ray), count,
        [&](std::size_t k) { return hits_of(rays.of_oracle[k], triangles); },
        [&](const RayHit& hit, const OracleHit<std::int64_t>& of_oracle, std::size_t) {
            return hit.t == quotient(of_oracle.height, of_oracle.det, exponent) &&
                   hit.u == quotient(of_oracle.edge1, of_oracle.det, 0) &&
                   hit.v == quotient(of_oracle.edge2, of_oracle.det, 0);
        });
}

/// Rays a mesh and scale. FIRSTHIT_TEST_RAYS makes it more: 160000 are ten million in all.
std::size_t rays_a_case()
{
    const char* const text = std::getenv("FIRSTHIT_TEST_RAYS");
    return text ? std::strtoul(text, nullptr, 10) : 4000;
}

TEST(LatticeRays, HitWhatWholeNumbersSay)
{
    std::size_t rays = 0, wrong = 0;
    unsigned seed = 1;
    for (const LatticeMesh& mesh : lattice_meshes())
        for (const LatticeScale& scale : kScales) {
            SCOPED_TRACE(mesh.name + ", scales " + std::to_string(scale.space) + ", " +
                         std::to_string(scale.direction));
            wrong += wrong_rays(mesh, scale, rays_a_case(), seed++);
            rays += rays_a_case();
        }
    EXPECT_EQ(wrong, 0U) << "of " << rays << " rays";
    RecordProperty("rays", int(rays));
}

TEST(LatticeRays, HaveTheSameBitsOnEveryInstructionSet)
{
    for (const LatticeMesh& lattice : lattice_meshes())
        for (const LatticeScale& scale : {kScales[0], kScales[3], kScales[5]}) {
            SCOPED_TRACE(lattice.name);
            std::mt19937 random(7);
            std::vector<glm::vec3> position;
            for (const glm::ivec3& p : lattice.corner) position.push_back(scaled(p, scale.space));
            const CastMesh mesh(position, lattice.triangle);
            const std::vector<Ray> rays = make_case(lattice, 1000, scale, random).ray;
            const CastAnswers first = mesh.cast(rays);
            for_instruction_sets([&] {
                const CastAnswers again = mesh.cast(rays);
                const auto same = [](const auto& a, const auto& b) {
                    return a.size() == b.size() &&
                           std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
                };
                EXPECT_TRUE(same(first.nearest, again.nearest));
                EXPECT_EQ(first.any, again.any);
                EXPECT_EQ(first.count, again.count);
                EXPECT_EQ(first.all_count, again.all_count);
                EXPECT_TRUE(same(first.all, again.all));
            });
        }
}

} // namespace
} // namespace firsthit::test
