// mesh_vertices_test.cpp - equal positions are one, normals are smooth up to the crease angle.
#include "readers/mesh/mesh_text.h"

#include "scene/model/smooth_normals.h"
#include "readers/mesh/weld.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

namespace firsthit::test {
namespace {

const LoadSettings kSmooth{.crease_angle_rad = std::numbers::pi};

TEST(Weld, FindsEqualValuesInOrderOfFirstAppearance)
{
    const std::vector<glm::vec3> values{
        {1, 2, 3}, {3, 2, 1}, {1, 2, 3}, {0, 0, 0}, {-0.f, 0, -0.f}};
    Tasks one(1);
    const Welded welded = weld(values, one);
    EXPECT_EQ(welded.number, (std::vector<std::uint32_t>{0, 1, 0, 2, 2}));
    EXPECT_EQ(welded.first, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Weld, KeepsValuesApartThatDifferInOneBit)
{
    const float x = 1.0f;
    const float next = std::nextafter(x, 2.0f);
    const std::vector<glm::vec3> values{{x, x, x}, {next, x, x}, {x, next, x}, {x, x, next}};
    Tasks one(1);
    EXPECT_EQ(weld(values, one).first.size(), 4u);
}

TEST(Weld, AgreesWithASetOnRandomValues)
{
    std::mt19937 random(3);
    std::vector<glm::vec3> values;
    std::set<std::tuple<float, float, float>> distinct;
    for (int i = 0; i < 100'000; ++i) {
        const auto coordinate = [&] { return static_cast<float>(random() % 21) - 10.0f; };
        values.emplace_back(coordinate(), coordinate(), coordinate());
        distinct.emplace(values.back().x, values.back().y, values.back().z);
    }
    Tasks one(1), three(3);
    const Welded welded = weld(values, one);
    EXPECT_EQ(welded.first.size(), distinct.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(values[welded.first[welded.number[i]]], values[i]);
    EXPECT_TRUE(std::is_sorted(welded.first.begin(), welded.first.end()));
    const Welded same = weld(values, three);
    EXPECT_EQ(same.number, welded.number);
    EXPECT_EQ(same.first, welded.first);
}

TEST(SmoothNormals, AreTheDirectionsFromTheMiddleOnACube)
{
    const Scene scene = read(kCubeObj, ".obj", kSmooth);
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
    EXPECT_EQ(read(kCubeObj, ".obj").vertices, 24u); // the default is 30 degrees
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
    EXPECT_EQ(read(obj, ".obj", kSmooth).vertices, 5u);
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

TEST(SmoothNormals, DoNotDependOnThreads)
{
    // A crumpled sheet of several ranges of points, with edges of three triangles and more.
    std::mt19937 random(9);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<glm::vec3> position;
    for (int v = 0; v < 20'000; ++v)
        position.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    std::vector<glm::uvec3> index;
    for (int t = 0; t < 60'000; ++t) {
        const auto first = static_cast<std::uint32_t>(random() % 19'990);
        index.emplace_back(first, first + 1 + random() % 4, first + 5 + random() % 4);
    }
    for (const double crease : {0.0, 0.6, 2.0, 4.0}) {
        const SmoothNormals one = smooth_normals(position, index, crease);
        for (const int threads : {2, 5}) {
            Tasks tasks(threads);
            const SmoothNormals many = smooth_normals(position, index, crease, tasks);
            EXPECT_EQ(many.normal, one.normal);
            EXPECT_EQ(many.corner, one.corner);
        }
    }
}

/// The groups of corners by the definition, and slowly: edges in pairs that follow one another in file
/// order, joined where the angle allows it.
std::vector<std::size_t> plain_groups(
    const std::vector<glm::vec3>& position, const std::vector<glm::uvec3>& index, double crease)
{
    std::vector<glm::dvec3> normal;
    for (const glm::uvec3& t : index) {
        const glm::dvec3 a(position[t.x]);
        normal.push_back(glm::cross(glm::dvec3(position[t.y]) - a, glm::dvec3(position[t.z]) - a));
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> triangles;
    for (std::size_t t = 0; t < index.size(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles[std::minmax(index[t][k], index[t][(k + 1) % 3])].push_back(t);
    std::vector<std::size_t> group(3 * index.size());
    std::iota(group.begin(), group.end(), std::size_t(0));
    const auto corner_at = [&](std::size_t t, std::uint32_t point) {
        for (std::size_t k = 0; k < 3; ++k)
            if (index[t][int(k)] == point) return 3 * t + k;
        return std::size_t(0);
    };
    for (const auto& [ends, list] : triangles)
        for (std::size_t i = 1; i < list.size(); ++i) {
            const glm::dvec3 &a = normal[list[i - 1]], &b = normal[list[i]];
            if (std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b))) > crease) continue;
            for (const std::uint32_t point : {ends.first, ends.second}) {
                const std::size_t from = group[corner_at(list[i], point)];
                const std::size_t to = group[corner_at(list[i - 1], point)];
                for (std::size_t& g : group)
                    if (g == from) g = to;
            }
        }
    return group;
}

TEST(SmoothNormals, GroupCornersAsTheDefinitionSays)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    for (int round = 0; round < 60; ++round) {
        std::vector<glm::vec3> position;
        for (int v = 0; v < 12; ++v)
            position.emplace_back(
                coordinate(random), coordinate(random), 0.4f * coordinate(random));
        std::vector<glm::uvec3> index;
        for (int t = 0; t < 40; ++t) {
            const auto a = static_cast<std::uint32_t>(random() % 12);
            index.emplace_back(a, (a + 1 + random() % 5) % 12, (a + 6 + random() % 6) % 12);
        }
        const double crease = 0.3 + 0.04 * round;
        const std::vector<std::size_t> group = plain_groups(position, index, crease);
        const std::vector<std::uint32_t> corner = smooth_normals(position, index, crease).corner;
        for (std::size_t a = 0; a < group.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                ASSERT_EQ(group[a] == group[b], corner[a] == corner[b])
                    << round << ' ' << a << ' ' << b;
    }
}

} // namespace
} // namespace firsthit::test
