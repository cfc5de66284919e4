// tessellate_test.cpp - spheres and cones as triangles.
#include "readers/aff/tessellate.h"
#include "readers/aff/aff_text.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace firsthit {
namespace {

using aff::Facets;

/// How often each edge is used in each direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const Facets& facets)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : facets.triangle)
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    return edges;
}

/// The least of (geometric normal) . (each corner's normal); below 0 something faces the wrong way.
float worst_facing(const Facets& facets)
{
    float worst = 1;
    for (const glm::uvec3& t : facets.triangle) {
        const glm::vec3 n = glm::normalize(glm::cross(facets.position[t.y] - facets.position[t.x],
            facets.position[t.z] - facets.position[t.x]));
        for (int k = 0; k < 3; ++k) worst = std::min(worst, glm::dot(n, facets.normal[t[k]]));
    }
    return worst;
}

TEST(Tessellate, GivesSpheresTheDocumentedNumberOfTriangles)
{
    for (const int n : {4, 8, 32, 64})
        EXPECT_EQ(
            aff::tessellate_sphere({0, 0, 0}, 1, n).triangle.size(), std::size_t(n * (n - 2)));
}

TEST(Tessellate, MakesTwoPyramidsOfThreeSegments)
{
    const Facets sphere = aff::tessellate_sphere({0, 0, 0}, 1, 3);
    EXPECT_EQ(sphere.triangle.size(), 6u); // three above the equator, three below
    EXPECT_EQ(sphere.position.size(), 5u);
    EXPECT_GT(worst_facing(sphere), 0.4f);
    const Facets prism = aff::tessellate_cone({.base_radius = 1, .apex_radius = 1}, 3);
    EXPECT_EQ(prism.triangle.size(), 6u);
    EXPECT_GT(worst_facing(prism), 0.49f);
    const LoadSettings settings = {.sphere_segments = 3, .cone_segments = 3};
    EXPECT_EQ(scene_of("s 0 0 0 1", {}, settings).triangle_count(), 6u);
    EXPECT_EQ(scene_of("c 0 0 0 1 0 1 0 0", {}, settings).triangle_count(), 3u);
}

TEST(Tessellate, ClosesSpheres)
{
    for (const int n : {3, 4, 5, 32}) {
        const auto edges = edges_of(aff::tessellate_sphere({0, 0, 0}, 1, n));
        for (const auto& [edge, uses] : edges) {
            EXPECT_EQ(uses, 1);
            EXPECT_TRUE(edges.contains({edge.second, edge.first}));
        }
    }
}

TEST(Tessellate, PutsTheVerticesOnTheSphere)
{
    const Facets sphere = aff::tessellate_sphere({1, 2, 3}, 2, 16);
    for (std::size_t v = 0; v < sphere.position.size(); ++v) {
        const glm::vec3 out = (sphere.position[v] - glm::vec3(1, 2, 3)) / 2.0f;
        EXPECT_NEAR(glm::length(out), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(out, sphere.normal[v]), 1.0f, 1e-6f);
    }
}

TEST(Tessellate, TurnsFacetsAsTheirNormals)
{
    EXPECT_GT(worst_facing(aff::tessellate_sphere({0, 0, 0}, 1, 32)), 0.9f);
    EXPECT_GT(worst_facing(aff::tessellate_sphere({0, 0, 0}, -1, 32)), 0.9f);
    EXPECT_GT(worst_facing(aff::tessellate_cone({.base_radius = 2, .apex_radius = 1}, 32)), 0.9f);
    EXPECT_GT(worst_facing(aff::tessellate_cone({.base_radius = -1, .apex_radius = -2}, 32)), 0.9f);
    EXPECT_GT(worst_facing(aff::tessellate_cone({.base_radius = 0, .apex_radius = 1}, 32)), 0.9f);
}

TEST(Tessellate, TurnsNegativeRadiiInsideOut)
{
    const Facets inside = aff::tessellate_sphere({0, 0, 0}, -1, 8);
    for (std::size_t v = 0; v < inside.position.size(); ++v)
        EXPECT_LT(glm::dot(inside.position[v], inside.normal[v]), 0);
}

TEST(Tessellate, GivesConesTheDocumentedNumberOfTriangles)
{
    EXPECT_EQ(aff::tessellate_cone({.base_radius = 1, .apex_radius = 1}, 20).triangle.size(), 40u);
    EXPECT_EQ(aff::tessellate_cone({.base_radius = 1, .apex_radius = 0}, 20).triangle.size(), 20u);
    EXPECT_EQ(aff::tessellate_cone({.base_radius = 0, .apex_radius = 1}, 20).triangle.size(), 20u);
    EXPECT_EQ(aff::tessellate_cone({.base_radius = 0, .apex_radius = 0}, 20).triangle.size(), 0u);
}

TEST(Tessellate, LeansTheNormalsOfConesTowardsTheirTip)
{
    // Base radius and height 1: everything leans by 45 degrees.
    const Facets cone = aff::tessellate_cone({.base_radius = 1, .apex_radius = 0}, 16);
    for (const glm::vec3& n : cone.normal) EXPECT_NEAR(n.y, std::sqrt(0.5f), 1e-6f);
}

TEST(Tessellate, PutsRingsAroundAnyAxis)
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, 3));
    const Facets tube = aff::tessellate_cone(
        {.base = {0, 0, 0}, .base_radius = 1, .apex = axis, .apex_radius = 1}, 8);
    for (const glm::vec3& p : tube.position) {
        const glm::dvec3 q(p);
        EXPECT_NEAR(glm::length(q - glm::dot(q, axis) * axis), 1.0, 1e-6);
    }
}

TEST(Tessellate, FollowsTheSettings)
{
    const LoadSettings settings = {.sphere_segments = 8, .cone_segments = 5};
    EXPECT_EQ(scene_of("s 0 0 0 1", {}, settings).triangle_count(), 48u);
    EXPECT_EQ(scene_of("c 0 0 0 1 0 1 0 1", {}, settings).triangle_count(), 10u);
    EXPECT_EQ(scene_of("s 0 0 0 1").triangle_count(), 960u);
}

TEST(Tessellate, LeavesOutAConeWithoutRadiiAndSaysSo)
{
    const Scene scene = scene_of("c 0 0 0 0 0 1 0 0");
    EXPECT_EQ(scene.triangle_count(), 0u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "main.aff:1: a cone without radii is left out");
}

TEST(Tessellate, RefusesNumbersOfSegmentsOutOfRange)
{
    for (const int n : {-1, 0, 2, 4097}) {
        EXPECT_THROW(scene_of(kTriangle, {}, {.sphere_segments = n}), ArgumentError);
        EXPECT_THROW(scene_of(kTriangle, {}, {.cone_segments = n}), ArgumentError);
    }
}

} // namespace
} // namespace firsthit
