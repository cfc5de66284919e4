// tangents_test.cpp - tangents of meshes that bring none.
#include "scene/model/tangents.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit {
namespace {

const glm::mat3x2 kPlain(1.0f);

/// A part of a sphere, (columns + 1) x (rows + 1) vertices, u around the y axis and v upwards.
Mesh sphere(int columns, int rows, float u_sign = 1)
{
    Mesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const float u = float(i) / float(columns), v = float(j) / float(rows);
            const float around = 3 * u, up = 2 * v - 1;
            mesh.position.emplace_back(
                std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
            mesh.normal.push_back(mesh.position.back());
            mesh.uv.emplace_back(u_sign * u, v);
        }
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto at = [&](int x, int y) { return unsigned((j + y) * (columns + 1) + i + x); };
            mesh.index.emplace_back(at(0, 0), at(1, 0), at(1, 1));
            mesh.index.emplace_back(at(0, 0), at(1, 1), at(0, 1));
        }
    return mesh;
}

TEST(Tangents, GoTheWayThatUGrows)
{
    for (const float u_sign : {1.0f, -1.0f}) {
        const Mesh mesh = sphere(24, 24, u_sign);
        const std::vector<glm::vec4> tangents = derived_tangents(mesh, mesh.uv, kPlain);
        ASSERT_EQ(tangents.size(), mesh.position.size());
        for (std::size_t v = 0; v < tangents.size(); ++v) {
            const glm::vec3 t(tangents[v]), n = mesh.normal[v];
            const glm::vec3 east = u_sign * glm::normalize(glm::cross(glm::vec3(0, 1, 0), n));
            EXPECT_NEAR(glm::length(t), 1, 1e-5);
            EXPECT_NEAR(glm::dot(t, n), 0, 1e-5);
            EXPECT_GT(glm::dot(t, east), 0.995f) << v;
            // The bitangent goes the way that v grows, also where the texture is mirrored.
            EXPECT_GT((tangents[v].w * glm::cross(n, t)).y, 0.4f) << v;
            EXPECT_EQ(tangents[v].w, u_sign);
        }
    }
}

TEST(Tangents, FollowTheTransformOfTheTexture)
{
    const Mesh mesh = sphere(16, 16);
    // A quarter turn: u' = v, v' = -u.
    const std::vector<glm::vec4> turned =
        derived_tangents(mesh, mesh.uv, glm::mat3x2(0, -1, 1, 0, 0, 0));
    const std::vector<glm::vec4> plain = derived_tangents(mesh, mesh.uv, kPlain);
    for (std::size_t v = 0; v < turned.size(); ++v) {
        const glm::vec3 north = glm::cross(mesh.normal[v], glm::vec3(plain[v]));
        EXPECT_GT(glm::dot(glm::vec3(turned[v]), north), 0.98f);
        EXPECT_EQ(turned[v].w, 1.0f);
    }
}

TEST(Tangents, AreSomeUnitVectorsWhereNothingIsSaid)
{
    Mesh mesh = sphere(4, 4);
    for (glm::vec2& uv : mesh.uv) uv = glm::vec2(0.5f);
    mesh.position.emplace_back(9, 9, 9); // of no triangle
    mesh.normal.emplace_back(0);
    mesh.uv.emplace_back(0);
    const std::vector<glm::vec4> tangents = derived_tangents(mesh, mesh.uv, kPlain);
    for (std::size_t v = 0; v < tangents.size(); ++v) {
        EXPECT_NEAR(glm::length(glm::vec3(tangents[v])), 1, 1e-5);
        EXPECT_NEAR(glm::dot(glm::vec3(tangents[v]), mesh.normal[v]), 0, 1e-5);
        EXPECT_EQ(std::abs(tangents[v].w), 1.0f);
    }
}

TEST(Tangents, CountTrianglesByTheirAngle)
{
    // Two triangles share a corner at (0, 0): a right angle with u along x, and one of 45 degrees
    // with u along y; the weights are the angles, however large the triangles are.
    Mesh mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-100, 0, 0}, {-100, -100, 0}};
    mesh.normal.assign(5, {0, 0, 1});
    mesh.uv = {{0, 0}, {1, 0}, {0, 1}, {0, 100}, {-100, 100}};
    mesh.index = {{0, 1, 2}, {0, 3, 4}};
    const glm::vec4 t = derived_tangents(mesh, mesh.uv, kPlain)[0];
    const double angle = std::atan2(0.5, 1.0); // of 90 degrees along x and 45 along y
    EXPECT_NEAR(t.x, std::cos(angle), 1e-5);
    EXPECT_NEAR(t.y, std::sin(angle), 1e-5);
}

TEST(Tangents, NeedNoNormals)
{
    Mesh mesh = sphere(8, 8);
    const std::vector<glm::vec4> smooth = derived_tangents(mesh, mesh.uv, kPlain);
    mesh.normal.clear();
    const std::vector<glm::vec4> flat = derived_tangents(mesh, mesh.uv, kPlain);
    for (std::size_t v = 0; v < flat.size(); ++v) {
        EXPECT_GT(glm::dot(glm::vec3(flat[v]), glm::vec3(smooth[v])), 0.9f);
        EXPECT_EQ(flat[v].w, 1.0f);
    }
}

} // namespace
} // namespace firsthit
