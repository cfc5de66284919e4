// shapes_test.cpp - the solids that robots are made of are closed and look outwards.
#include "readers/mesh/weld.h"
#include "samples/shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace firsthit {
namespace {

void expect_closed(const Shape& shape)
{
    ASSERT_FALSE(shape.index.empty());
    Tasks alone(1);
    const Welded points = weld(shape.position, alone);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : shape.index)
        for (int k = 0; k < 3; ++k) ++edges[{points.number[t[k]], points.number[t[(k + 1) % 3]]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ((edges.count({edge.second, edge.first})), 1u);
    }
}

void expect_outward(const Shape& shape)
{
    for (const glm::uvec3& t : shape.index) {
        const glm::vec3 a = shape.position[t.x];
        const glm::vec3 face = glm::cross(shape.position[t.y] - a, shape.position[t.z] - a);
        EXPECT_GT(glm::dot(face, a), 0.0f); // convex around the origin
        for (int k = 0; k < 3; ++k) {
            EXPECT_GT(glm::dot(face, shape.normal[t[k]]), 0.0f);
            EXPECT_NEAR(glm::length(shape.normal[t[k]]), 1.0f, 1e-6f);
        }
    }
}

TEST(Shapes, EllipsoidIsClosedAndLooksOutwards)
{
    for (const int segments : {6, 8, 15}) {
        Shape shape;
        add_ellipsoid(shape, {0.1, 0.2, 0.3}, segments);
        expect_closed(shape);
        expect_outward(shape);
    }
}

TEST(Shapes, RoundedBoxIsClosedAndLooksOutwards)
{
    for (const int segments : {1, 2, 5})
        for (const double taper : {1.0, 0.7}) {
            Shape shape;
            add_rounded_box(shape, {0.3, 0.2, 0.1}, 0.05, segments, glm::dmat4(1), taper);
            expect_closed(shape);
            expect_outward(shape);
        }
}

TEST(Shapes, LatheWithACreaseIsClosedAndKeepsItSharp)
{
    Shape shape;
    const auto cylinder =
        std::to_array<Outline>({{0, 1}, {0.5, 1}, {0.5, 1}, {0.5, -1}, {0.5, -1}, {0, -1}});
    add_lathe(shape, cylinder, 12);
    expect_closed(shape);
    expect_outward(shape);
    for (const glm::vec3& n : shape.normal)
        EXPECT_NEAR(std::abs(n.y) < 0.5f ? n.y : std::abs(n.y) - 1, 0.0f, 1e-6f);
}

} // namespace
} // namespace firsthit
