// mesh_vertices_test.cpp - equal positions are one, normals are smooth up to the crease angle.
#include "readers/mesh/mesh_text.h"

#include "scene/model/smooth_normals.h"
#include "readers/mesh/weld.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

namespace firsthit::test {
namespace {

TEST(Weld, FindsEqualValuesInOrderOfFirstAppearance)
{
    const std::vector<glm::vec3> values{
        {1, 2, 3}, {3, 2, 1}, {1, 2, 3}, {0, 0, 0}, {-0.f, 0, -0.f}};
    const Welded welded = weld(values);
    EXPECT_EQ(welded.number, (std::vector<std::uint32_t>{0, 1, 0, 2, 2}));
    EXPECT_EQ(welded.first, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Weld, KeepsValuesApartThatDifferInOneBit)
{
    const float x = 1.0f;
    const float next = std::nextafter(x, 2.0f);
    const std::vector<glm::vec3> values{{x, x, x}, {next, x, x}, {x, next, x}, {x, x, next}};
    EXPECT_EQ(weld(values).first.size(), 4u);
}

TEST(Weld, AgreesWithASetOnRandomValues)
{
    std::mt19937 random(3);
    std::vector<glm::vec3> values;
    std::set<std::tuple<float, float, float>> distinct;
    for (int i = 0; i < 20000; ++i) {
        const auto coordinate = [&] { return static_cast<float>(random() % 21) - 10.0f; };
        values.emplace_back(coordinate(), coordinate(), coordinate());
        distinct.emplace(values.back().x, values.back().y, values.back().z);
    }
    const Welded welded = weld(values);
    EXPECT_EQ(welded.first.size(), distinct.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(values[welded.first[welded.number[i]]], values[i]);
}

TEST(SmoothNormals, AreTheDirectionsFromTheMiddleOnACube)
{
    const Scene scene = read(kCubeObj, ".obj");
    for (std::size_t v = 0; v < scene.vertices; ++v) {
        const glm::vec3 expected = glm::normalize(scene.position[v] - glm::vec3(0.5f));
        EXPECT_LT(glm::length(scene.normal[v] - expected), 1e-5f);
    }
}

TEST(SmoothNormals, SplitACubeAtItsEdgesBelowNinetyDegrees)
{
    LoadSettings settings;
    settings.crease_angle_rad = 1.5;
    const Scene scene = read(kCubeObj, ".obj", settings);
    EXPECT_EQ(scene.vertices, 24u);
    for (const glm::vec3& n : scene.normal)
        EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0f, 1e-6f);
    settings.crease_angle_rad = 1.6;
    EXPECT_EQ(read(kCubeObj, ".obj", settings).vertices, 8u);
}

TEST(SmoothNormals, MakeEveryTriangleFlatAtACreaseAngleOfZeroOnABentStrip)
{
    LoadSettings settings;
    settings.crease_angle_rad = 0;
    const Scene scene =
        read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 1 3 4\n", ".obj", settings);
    EXPECT_EQ(scene.vertices, 6u);
}

TEST(SmoothNormals, PassAroundAPointOnlyAcrossSmoothEdges)
{
    // Two flat sheets that touch in one point share no edge there.
    LoadSettings settings;
    settings.crease_angle_rad = 1.0;
    const char* const obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 0 1\nf 1 2 3\nf 1 4 5\n";
    EXPECT_EQ(read(obj, ".obj", settings).vertices, 6u);
    EXPECT_EQ(read(obj, ".obj").vertices, 5u);
}

TEST(SmoothNormals, DoNotDependOnHowAFaceIsCutOnASphere)
{
    // Max's weights give the sphere's own normals whatever the triangles.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<glm::vec3> position{{0, 0, 1}};
    std::vector<glm::uvec3> index;
    constexpr std::uint32_t kRing = 7;
    for (std::uint32_t k = 0; k < kRing; ++k) {
        const double angle = 2 * std::numbers::pi * k / kRing + 0.2 * coordinate(random);
        const double tilt = 0.5 + 0.3 * coordinate(random);
        position.emplace_back(
            std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle), std::cos(tilt));
        index.emplace_back(0, 1 + k, 1 + (k + 1) % kRing);
    }
    const SmoothNormals made = smooth_normals(position, index, 4.0);
    EXPECT_LT(glm::length(made.normal[0] - glm::vec3(0, 0, 1)), 1e-5f);
}

TEST(SmoothNormals, AreUnitForTinyHugeAndDegenerateTriangles)
{
    const float tiny = std::numeric_limits<float>::denorm_min();
    const float huge = std::numeric_limits<float>::max();
    const std::vector<glm::vec3> position{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {huge, -huge, 0},
        {-huge, huge, huge}, {huge, huge, huge}};
    const std::vector<glm::uvec3> index{{0, 1, 2}, {3, 4, 5}, {0, 0, 1}, {5, 5, 5}};
    for (const double crease : {0.0, 1.0, 4.0, std::nan("")})
        for (const glm::vec3& n : smooth_normals(position, index, crease).normal)
            EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
}

TEST(SmoothNormals, TakeAFanOfManyTrianglesInALinearTime)
{
    std::vector<glm::vec3> position{{0, 0, 1}};
    std::vector<glm::uvec3> index;
    constexpr std::uint32_t kRing = 200'000;
    for (std::uint32_t k = 0; k < kRing; ++k) {
        const double angle = 2 * std::numbers::pi * k / kRing;
        position.emplace_back(std::cos(angle), std::sin(angle), 0);
        index.emplace_back(0, 1 + k, 1 + (k + 1) % kRing);
    }
    const SmoothNormals made = smooth_normals(position, index, 0.5);
    EXPECT_EQ(made.normal[made.corner[0]], made.normal[made.corner[3 * (kRing / 2)]]);
}

} // namespace
} // namespace firsthit::test
