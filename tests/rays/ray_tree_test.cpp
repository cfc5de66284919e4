// ray_tree_test.cpp - a tree that follows moving triangles answers as a loop over all of them does.
#include "rays/tree/ray_tree.h"

#include "exact/ray_hit.h"
#include "random_numbers.h"
#include "rays/cast_answers_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit::test {
namespace {

using glm::vec3;

struct Grid {
    std::vector<vec3> position;
    std::vector<glm::uvec3> index;
};

/// A sheet of 2 n^2 triangles with waves.
Grid make_grid(unsigned n, float phase)
{
    Grid grid;
    for (unsigned y = 0; y <= n; ++y)
        for (unsigned x = 0; x <= n; ++x) {
            const float fx = float(x) / float(n), fy = float(y) / float(n);
            grid.position.push_back({fx, fy, 0.2f * std::sin(20 * fx + phase) * std::sin(16 * fy)});
        }
    for (unsigned y = 0; y < n; ++y)
        for (unsigned x = 0; x < n; ++x) {
            const unsigned a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            grid.index.push_back({a, b, d});
            grid.index.push_back({d, c, a});
        }
    return grid;
}

std::vector<Ray> random_rays(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Ray> rays;
    for (std::size_t k = 0; k < count; ++k) {
        const auto place = [&] {
            return vec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, -0.3f, 0.3f));
        };
        const vec3 from = place();
        rays.push_back({from, place() - from});
    }
    return rays;
}

/// The nearest triangle by a loop over all of them.
std::uint32_t nearest_of_all(const CastMesh& mesh, const Ray& ray)
{
    Effort effort;
    std::uint32_t best = kNoItem;
    const auto corners = [&](std::uint32_t t) -> Corners {
        const glm::uvec3& c = mesh.index()[t];
        return {mesh.position()[c.x], mesh.position()[c.y], mesh.position()[c.z]};
    };
    for (std::uint32_t t = 0; t < mesh.index().size(); ++t)
        if (is_hit(ray, corners(t), effort) &&
            (best == kNoItem || compare_depth(ray, corners(t), corners(best), effort) < 0))
            best = t;
    return best;
}

void expect_nearest(const CastMesh& mesh, const std::vector<Ray>& rays)
{
    const CastAnswers answers = mesh.cast(rays);
    std::size_t hits = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const std::uint32_t wanted = nearest_of_all(mesh, rays[k]);
        ASSERT_EQ(answers.nearest[k].triangle, wanted) << "ray " << k;
        hits += wanted != kNoItem;
    }
    EXPECT_GT(hits, rays.size() / 10);
}

TEST(RayTree, FollowsWhatMoves)
{
    const Grid grid = make_grid(40, 0);
    CastMesh mesh(grid.position, grid.index);
    const std::vector<Ray> rays = random_rays(400, 1);
    expect_nearest(mesh, rays);
    for (const float phase : {0.5f, 1.0f, 3.0f}) {
        const RayTree::Counts before = RayTree::counts();
        mesh.move(make_grid(40, phase).position);
        EXPECT_EQ(RayTree::counts().refits, before.refits + 1);
        EXPECT_EQ(RayTree::counts().builds, before.builds) << "the waves are about as rough";
        expect_nearest(mesh, rays);
    }
}

TEST(RayTree, IsBuiltAnewWhereItsBoxesAreWorn)
{
    const Grid grid = make_grid(40, 0);
    CastMesh mesh(grid.position, grid.index);
    std::vector<vec3> mixed = grid.position;
    std::mt19937 random(2);
    std::shuffle(mixed.begin(), mixed.end(), random);
    const RayTree::Counts before = RayTree::counts();
    mesh.move(mixed);
    EXPECT_EQ(RayTree::counts().builds, before.builds + 1);
    expect_nearest(mesh, random_rays(100, 3));
}

/// What collapses to a point, or goes where nothing is visible, comes back.
TEST(RayTree, TakesTrianglesThatCannotBeHit)
{
    const Grid grid = make_grid(20, 0);
    std::vector<vec3> gone = grid.position;
    for (std::size_t k = 0; k < gone.size() / 3; ++k) gone[k] = vec3(0.5f);
    for (std::size_t k = gone.size() / 3; k < gone.size() / 2; ++k)
        gone[k].x = k % 2 ? 2e30f : std::nanf("");
    const std::vector<Ray> rays = random_rays(300, 4);
    CastMesh mesh(gone, grid.index);
    expect_nearest(mesh, rays);
    mesh.move(grid.position);
    expect_nearest(mesh, rays);
    mesh.move(gone);
    expect_nearest(mesh, rays);
    mesh.move(std::vector<vec3>(gone.size(), vec3(1)));
    for (const RayHit& hit : mesh.cast(rays).nearest) EXPECT_EQ(hit.triangle, kNoItem);
}

/// Triangles at distances that grow by a factor each: no split by area halves them.
TEST(RayTree, IsNotTooDeep)
{
    Grid grid;
    for (unsigned k = 0; k < 3000; ++k) {
        const float x = std::ldexp(1.0f, -100) * std::pow(1.02f, float(k));
        for (const vec3 p : {vec3(x, 0, 0), vec3(x, 1, 0), vec3(x, 0, 1)})
            grid.position.push_back(p);
        grid.index.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const CastMesh mesh(grid.position, grid.index);
    std::vector<Ray> rays;
    for (int k = 0; k < 20; ++k) rays.push_back({{-1, 0.1f, 0.04f * float(k)}, {1, 0, 0}});
    const CastAnswers answers = mesh.cast(rays);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        EXPECT_EQ(answers.nearest[k].triangle, 0U);
        EXPECT_EQ(answers.count[k], 3000U);
    }
}

TEST(RayTree, OfNothing)
{
    const CastMesh mesh({}, {});
    const CastAnswers answers = mesh.cast(random_rays(3, 5));
    for (const RayHit& hit : answers.nearest) EXPECT_EQ(hit.triangle, kNoItem);
    EXPECT_TRUE(answers.all.empty());
}

/// Such rays hit nothing, whatever else they say.
TEST(RayTree, RaysThatCannotBeMeant)
{
    const Grid grid = make_grid(4, 0);
    const CastMesh mesh(grid.position, grid.index);
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const Ray good{{0.4f, 0.4f, 1}, {0, 0, -1}};
    std::vector<Ray> rays(12, good);
    rays[0].direction = vec3(0);
    rays[1].direction.x = nan;
    rays[2].direction.z = -inf;
    rays[3].origin.y = nan;
    rays[4].origin.x = inf;
    rays[5].origin.z = 1e30f;
    rays[6].t_min = nan;
    rays[7].t_max = nan;
    rays[8].t_min = 2, rays[8].t_max = 1;
    rays[9].t_max = 0;
    rays[10].t_max = -1;
    rays[11].t_min = inf;
    for (const RayHit& hit : mesh.cast(rays).nearest) EXPECT_EQ(hit.triangle, kNoItem);
    EXPECT_NE(mesh.cast({good}).nearest[0].triangle, kNoItem);
}

} // namespace
} // namespace firsthit::test
