// skin_kernel_test.cpp - skinned vertices against one vertex at a time in double.
#include "scene/animate/skin_kernel.h"

#include "instruction_sets.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace firsthit {
namespace {

constexpr int kJoints = 7;

struct Skinned {
    int influences;
    std::vector<float> matrix;
    std::vector<std::uint16_t> joint;
    std::vector<float> weight;
    std::vector<glm::vec3> position, normal;
    std::vector<glm::vec4> tangent;

    Skinned(std::size_t count, int influence_count, std::uint32_t seed)
        : influences(influence_count)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> any(-1.0f, 1.0f);
        for (int j = 0; j < kJoints; ++j)
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r)
                    matrix.push_back(
                        r == 3 ? (c == 3 ? 1.0f : 0.0f) : any(random) + (r == c ? 2.0f : 0.0f));
        for (std::size_t v = 0; v < count; ++v) {
            float sum = 0;
            for (int k = 0; k < influences; ++k) {
                joint.push_back(std::uint16_t(random() % kJoints));
                weight.push_back(std::abs(any(random)) + 0.01f);
                sum += weight.back();
            }
            for (int k = 0; k < influences; ++k) weight[weight.size() - 1 - std::size_t(k)] /= sum;
            position.emplace_back(any(random), any(random), any(random));
            normal.push_back(glm::normalize(glm::vec3(any(random), any(random), 1.1f)));
            tangent.emplace_back(
                glm::normalize(glm::vec3(1.1f, any(random), any(random))), v % 2 ? 1 : -1);
        }
    }

    SkinnedVertices view() const
    {
        return {matrix.data(), influences, joint.data(), weight.data()};
    }

    glm::dmat4 blended(std::size_t v) const
    {
        glm::dmat4 sum(0);
        for (std::size_t k = 0; k < std::size_t(influences); ++k) {
            const std::size_t at = v * std::size_t(influences) + k;
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r)
                    sum[c][r] += double(weight[at]) *
                                 double(matrix[16 * joint[at] + std::size_t(4 * c + r)]);
        }
        return sum;
    }
};

TEST(SkinKernel, AgreesWithOneVertexAtATime)
{
    for (const int influences : {1, 2, 4, 8})
        for (const std::size_t count : {1u, 3u, 4u, 15u, 16u, 17u, 100u}) {
            const Skinned in(
                count, influences, std::uint32_t(influences * 1000) + std::uint32_t(count));
            std::vector<glm::vec3> position(count), normal(count);
            ASSERT_TRUE(skin_vertices(in.view(), count, {in.position.data(), in.normal.data()},
                {position.data(), normal.data()}));
            for (std::size_t v = 0; v < count; ++v) {
                const glm::dmat4 m = in.blended(v);
                const glm::dvec3 p(m * glm::dvec4(in.position[v], 1));
                const glm::dvec3 n = glm::normalize(
                    glm::transpose(glm::inverse(glm::dmat3(m))) * glm::dvec3(in.normal[v]));
                EXPECT_LT(glm::length(glm::dvec3(position[v]) - p), 2e-6);
                EXPECT_LT(glm::length(glm::dvec3(normal[v]) - n), 1e-4);
            }
        }
}

TEST(SkinKernel, TurnsTangentsAndMirrorsTheirSign)
{
    Skinned in(33, 4, 5);
    for (std::size_t k = 0; k < in.matrix.size(); k += 16) // all of them mirror
        for (std::size_t r = 0; r < 3; ++r) in.matrix[k + r] = -in.matrix[k + r];
    std::vector<glm::vec4> tangent(33);
    skin_tangents(in.view(), 33, in.tangent.data(), tangent.data());
    for (std::size_t v = 0; v < 33; ++v) {
        const glm::dmat3 m(in.blended(v));
        const glm::dvec3 t = glm::normalize(m * glm::dvec3(in.tangent[v]));
        EXPECT_LT(glm::length(glm::dvec3(tangent[v]) - t), 1e-5);
        EXPECT_EQ(tangent[v].w, glm::determinant(m) < 0 ? -in.tangent[v].w : in.tangent[v].w);
    }
}

TEST(SkinKernel, GivesTheSameBitsForEveryInstructionSet)
{
    const Skinned in(77, 4, 21);
    std::vector<glm::vec3> first_position, first_normal;
    for_instruction_sets([&] {
        std::vector<glm::vec3> position(77), normal(77);
        skin_vertices(in.view(), 77, {in.position.data(), in.normal.data()},
            {position.data(), normal.data()});
        if (first_position.empty()) {
            first_position = position;
            first_normal = normal;
        }
        EXPECT_EQ(position, first_position);
        EXPECT_EQ(normal, first_normal);
    });
}

TEST(SkinKernel, MayWriteWhereItReads)
{
    Skinned in(50, 4, 9);
    std::vector<glm::vec3> position(50), normal(50);
    skin_vertices(
        in.view(), 50, {in.position.data(), in.normal.data()}, {position.data(), normal.data()});
    skin_vertices(in.view(), 50, {in.position.data(), in.normal.data()},
        {in.position.data(), in.normal.data()});
    EXPECT_EQ(in.position, position);
    EXPECT_EQ(in.normal, normal);
}

TEST(SkinKernel, SaysWhatIsNotFinite)
{
    for (std::size_t bad = 0; bad < 20; ++bad) {
        Skinned in(20, 4, 3);
        in.position[bad].y = std::numeric_limits<float>::infinity();
        std::vector<glm::vec3> position(20), normal(20);
        EXPECT_FALSE(skin_vertices(in.view(), 20, {in.position.data(), in.normal.data()},
            {position.data(), normal.data()}));
    }
}

TEST(SkinKernel, GivesANormalWhereTheMatrixIsFlat)
{
    Skinned in(4, 1, 1);
    for (std::size_t k = 0; k < in.matrix.size(); ++k) in.matrix[k] = 0;
    std::vector<glm::vec3> position(4), normal(4);
    EXPECT_TRUE(skin_vertices(
        in.view(), 4, {in.position.data(), in.normal.data()}, {position.data(), normal.data()}));
    for (const glm::vec3& n : normal) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(AddWeighted, RoundsProductAndSumOneAfterTheOther)
{
    std::vector<float> sum(37, 0.1f), term(37);
    for (std::size_t k = 0; k < 37; ++k) term[k] = 0.3f * float(k) - 2;
    std::vector<float> expected = sum;
    for (std::size_t k = 0; k < 37; ++k) {
        volatile float product = 0.7f * term[k];
        expected[k] = expected[k] + product;
    }
    add_weighted(0.7f, term.data(), 37, sum.data());
    EXPECT_EQ(sum, expected);
}

} // namespace
} // namespace firsthit
