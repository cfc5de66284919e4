// pose_kernel_test.cpp - the vertex mover, the same for every instruction set.
#include "scene/animate/pose_kernel.h"

#include "instruction_sets.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace firsthit {
namespace {

using Points = std::vector<glm::vec3>;

glm::dmat4 some_matrix()
{
    const glm::dmat4 t = glm::translate(glm::dmat4(1), glm::dvec3(10, -20, 30));
    const glm::dmat4 r = glm::rotate(t, 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    return glm::scale(r, glm::dvec3(1, 0.5, 3));
}

Points random_points(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<float> any;
    Points points(count);
    for (glm::vec3& p : points) p = {any(random), any(random), any(random)};
    return points;
}

/// One vertex in plain code, with the roundings of the kernel.
void move_plainly(const VertexMatrix& m, glm::vec3& p, glm::vec3& n)
{
    const glm::vec3 from = p, up = n;
    for (int r = 0; r < 3; ++r) {
        const float* row = m.point + 4 * r;
        p[r] = ((row[0] * from.x + row[1] * from.y) + row[2] * from.z) + row[3];
        const float* turn = m.normal + 3 * r;
        n[r] = (turn[0] * up.x + turn[1] * up.y) + turn[2] * up.z;
    }
    n *= 1.0f / std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
}

bool same_bits(const Points& a, const Points& b)
{
    return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0;
}

TEST(PoseKernel, AgreesBitForBitWithPlainCodeForEveryCount)
{
    const VertexMatrix matrix = vertex_matrix(some_matrix());
    for_instruction_sets([&] {
        for (std::size_t count = 0; count <= 40; ++count) {
            const Points p = random_points(count, 1), n = random_points(count, 2);
            Points plain_p = p, plain_n = n, moved_p(count), moved_n(count);
            for (std::size_t k = 0; k < count; ++k) move_plainly(matrix, plain_p[k], plain_n[k]);
            EXPECT_TRUE(move_vertices(
                matrix, count, {p.data(), n.data()}, {moved_p.data(), moved_n.data()}));
            EXPECT_TRUE(same_bits(moved_p, plain_p)) << count;
            EXPECT_TRUE(same_bits(moved_n, plain_n)) << count;
        }
    });
}

TEST(PoseKernel, WorksInPlaceAndWritesNothingElse)
{
    const VertexMatrix matrix = vertex_matrix(some_matrix());
    for_instruction_sets([&] {
        const Points before = random_points(30, 3);
        Points p = before, n = before, expected(30), unused(30);
        move_vertices(matrix, 21, {p.data(), n.data()}, {expected.data(), unused.data()});
        move_vertices(matrix, 21, {p.data(), n.data()}, {p.data(), n.data()});
        for (std::size_t k = 0; k < 30; ++k) EXPECT_EQ(p[k], k < 21 ? expected[k] : before[k]);
    });
}

TEST(PoseKernel, TellsOfPositionsThatAreNotFiniteWhereverTheyAre)
{
    const VertexMatrix matrix = vertex_matrix(glm::scale(glm::dmat4(1), glm::dvec3(2)));
    for_instruction_sets([&] {
        for (std::size_t k = 0; k < 35; ++k)
            for (const float bad : {std::numeric_limits<float>::infinity(), std::nanf(""), 3e38f}) {
                Points p = random_points(35, 4), n = p;
                EXPECT_TRUE(move_vertices(matrix, 35, {p.data(), n.data()}, {p.data(), n.data()}));
                p[k][int(k % 3)] = bad;
                EXPECT_FALSE(move_vertices(matrix, 35, {p.data(), n.data()}, {p.data(), n.data()}));
            }
    });
}

TEST(PoseKernel, GivesZToNormalsWithoutDirection)
{
    const VertexMatrix matrix = vertex_matrix(glm::dmat4(1));
    for_instruction_sets([&] {
        Points p(3), n = {{0, 0, 0}, {std::nanf(""), 0, 0}, {0, 3e38f, 0}};
        move_vertices(matrix, 3, {p.data(), n.data()}, {p.data(), n.data()});
        for (const glm::vec3& normal : n) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    });
}

TEST(PoseKernel, RoundsTheMatrixOnce)
{
    const glm::dmat4 m = some_matrix();
    const VertexMatrix matrix = vertex_matrix(m);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) EXPECT_EQ(matrix.point[4 * r + c], static_cast<float>(m[c][r]));
}

} // namespace
} // namespace firsthit
