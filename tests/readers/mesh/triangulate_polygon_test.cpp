// triangulate_polygon_test.cpp - polygons are cut into triangles that cover them once and nothing else.
#include "readers/mesh/triangulate_polygon.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>

namespace firsthit::test {
namespace {

using Polygon = std::vector<glm::i64vec2>; // on a grid, so that all areas are exact

std::int64_t doubled_area(const glm::i64vec2& a, const glm::i64vec2& b, const glm::i64vec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t doubled_area(const Polygon& polygon)
{
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::i64vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// How often an outline goes around a point, which no line through two of its corners at these
/// fractions of a grid step meets: counts edges that cross the ray to the right.
int winding(const Polygon& polygon, double x, double y)
{
    int around = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec2 a(polygon[k]), b(polygon[(k + 1) % polygon.size()]);
        if ((a.y > y) == (b.y > y)) continue;
        if (a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) > x) around += b.y > a.y ? 1 : -1;
    }
    return around;
}

struct Cut {
    std::vector<glm::uvec3> triangles;
    bool sound = false;
};

/// In the plane spanned by two axes; `flip` sees it from behind.
Cut cut(const Polygon& polygon, int axis = 2, bool flip = false)
{
    std::vector<glm::vec3> corner;
    for (const glm::i64vec2& p : polygon) {
        glm::vec3& c = corner.emplace_back(7.0f);
        c[(axis + 1) % 3] = static_cast<float>(flip ? p.y : p.x);
        c[(axis + 2) % 3] = static_cast<float>(flip ? p.x : p.y);
    }
    Cut made;
    made.sound = triangulate_polygon(corner, made.triangles);
    return made;
}

/// Oracle: no triangle is turned over, and together they have the polygon's area and cover what it covers.
void expect_covered(const Polygon& polygon, const Cut& made)
{
    EXPECT_TRUE(made.sound);
    ASSERT_EQ(made.triangles.size(), polygon.size() - 2);
    const int way = doubled_area(polygon) > 0 ? 1 : -1;
    std::int64_t sum = 0;
    for (const glm::uvec3& t : made.triangles) {
        const std::int64_t area = doubled_area(polygon[t.x], polygon[t.y], polygon[t.z]);
        EXPECT_GE(area * way, 0) << t.x << ' ' << t.y << ' ' << t.z;
        sum += area;
    }
    EXPECT_EQ(sum, doubled_area(polygon));

    std::mt19937 random(3);
    std::int64_t low = polygon[0].x, high = low;
    for (const glm::i64vec2& p : polygon) {
        low = std::min({low, p.x, p.y});
        high = std::max({high, p.x, p.y});
    }
    std::uniform_real_distribution<double> place(double(low) - 1, double(high) + 1);
    for (int k = 0; k < 50; ++k) {
        const double x = place(random), y = place(random);
        int covered = 0;
        for (const glm::uvec3& t : made.triangles)
            covered += winding({polygon[t.x], polygon[t.y], polygon[t.z]}, x, y);
        EXPECT_EQ(covered, winding(polygon, x, y)) << x << ' ' << y;
    }
}

bool edges_cross(
    const glm::i64vec2& a, const glm::i64vec2& b, const glm::i64vec2& c, const glm::i64vec2& d)
{
    const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
    const int abc = sign(doubled_area(a, b, c)), abd = sign(doubled_area(a, b, d));
    const int cda = sign(doubled_area(c, d, a)), cdb = sign(doubled_area(c, d, b));
    if (abc != abd && cda != cdb) return true;             // also where one touches the other
    return abc == 0 && abd == 0 && cda == 0 && cdb == 0 && // on one line: their boxes overlap
           std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

/// Random points, whose tour is untangled by turning pieces of it around until no edges cross. Empty
/// where that comes to no end.
Polygon random_outline(std::size_t corners, int grid, std::mt19937& random)
{
    Polygon p;
    while (p.size() < corners) {
        const glm::i64vec2 made(random() % unsigned(grid), random() % unsigned(grid));
        if (std::find(p.begin(), p.end(), made) == p.end()) p.push_back(made);
    }
    for (int round = 0; round < 2000; ++round) {
        bool crossed = false;
        for (std::size_t i = 0; i < corners && !crossed; ++i)
            for (std::size_t j = i + 2; j < corners && !crossed; ++j) {
                if (i == 0 && j == corners - 1) continue;
                crossed = edges_cross(p[i], p[i + 1], p[j], p[(j + 1) % corners]);
                if (crossed)
                    std::reverse(
                        p.begin() + std::ptrdiff_t(i) + 1, p.begin() + std::ptrdiff_t(j) + 1);
            }
        if (!crossed) return p;
    }
    return {};
}

TEST(TriangulatePolygon, KeepsTheFanOfConvexPolygons)
{
    for (std::uint32_t n = 3; n < 40; ++n) {
        std::vector<glm::vec3> corner;
        for (std::uint32_t k = 0; k < n; ++k) {
            const double angle = 2 * 3.14159265358979 * k / n;
            corner.emplace_back(float(std::cos(angle)), float(std::sin(angle)), 0.5f);
        }
        std::vector<glm::uvec3> triangles;
        EXPECT_TRUE(triangulate_polygon(corner, triangles));
        ASSERT_EQ(triangles.size(), n - 2);
        for (std::uint32_t k = 0; k < n - 2; ++k)
            EXPECT_EQ(triangles[k], glm::uvec3(0, k + 1, k + 2));
    }
}

TEST(TriangulatePolygon, AppendsToWhatIsThere)
{
    std::vector<glm::uvec3> triangles{{9, 9, 9}};
    triangulate_polygon(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, triangles);
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_EQ(triangles[0], glm::uvec3(9));
    EXPECT_EQ(triangles[1], glm::uvec3(0, 1, 2));
}

TEST(TriangulatePolygon, CutsAnArrowAtItsHollowCorner)
{
    // Whichever of the four corners comes first.
    Polygon arrow{{0, 0}, {10, 5}, {0, 10}, {4, 5}};
    for (int k = 0; k < 4; ++k) {
        expect_covered(arrow, cut(arrow));
        std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    }
}

TEST(TriangulatePolygon, CoversRandomOutlinesOnce)
{
    std::mt19937 random(20061);
    int found = 0;
    for (int round = 0; round < 1500; ++round) {
        const std::size_t corners = 4 + random() % 30;
        // Small grids have many corners in a line and edges that nearly touch.
        const int grid = round % 3 == 0 ? 7 : round % 3 == 1 ? 40 : 4000;
        Polygon p = random_outline(corners, grid, random);
        if (p.empty()) continue;
        ++found;
        expect_covered(p, cut(p, round % 3, round % 2 == 0));
        std::reverse(p.begin(), p.end()); // seen from behind
        expect_covered(p, cut(p, round % 3, round % 2 == 0));
        ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
    }
    EXPECT_GT(found, 1000);
}

TEST(TriangulatePolygon, CoversOutlinesWithRepeatedCornersAndSpikes)
{
    std::mt19937 random(5);
    int found = 0;
    for (int round = 0; round < 500; ++round) {
        Polygon p = random_outline(4 + random() % 12, 30, random);
        if (p.empty() || doubled_area(p) == 0) continue;
        ++found;
        for (int k = 0; k < 4; ++k) {
            const auto at = std::ptrdiff_t(random() % p.size());
            const glm::i64vec2 here = p[std::size_t(at)];
            p.insert(p.begin() + at, here); // twice
        }
        // Out along an edge and back again.
        const glm::i64vec2 a = p[0], b = p[1];
        p.insert(p.begin() + 1, {b, a});
        expect_covered(p, cut(p));
        ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
    }
    EXPECT_GT(found, 300);
}

TEST(TriangulatePolygon, CoversPolygonsWithHolesThatEdgesLeadTo)
{
    // A square with holes in a row; from the lower side an edge goes up to each hole and back.
    for (int holes = 1; holes < 20; ++holes) {
        Polygon p{{0, 0}};
        for (int h = 0; h < holes; ++h) {
            const int x = 10 + 20 * h;
            p.insert(
                p.end(), {{x, 0}, {x, 10}, {x - 5, 20}, {x, 30}, {x + 5, 20}, {x, 10}, {x, 0}});
        }
        const int end = 20 * holes;
        p.insert(p.end(), {{end, 0}, {end, 40}, {0, 40}});
        ASSERT_EQ(doubled_area(p), 2 * (40 * end - 100 * holes));
        expect_covered(p, cut(p));
        std::rotate(p.begin(), p.begin() + 3, p.end());
        expect_covered(p, cut(p));
    }
}

TEST(TriangulatePolygon, CoversAPolygonInATiltedPlane)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int round = 0; round < 200; ++round) {
        const Polygon p = random_outline(12, 1000, random);
        if (p.empty()) continue;
        const glm::dvec3 x =
            glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.3, 0.5, -0.8)));
        std::vector<glm::vec3> corner;
        for (const glm::i64vec2& q : p) corner.emplace_back(x * double(q.x) + y * double(q.y));
        Cut made;
        made.sound = triangulate_polygon(corner, made.triangles);
        EXPECT_TRUE(made.sound);
        double sum = 0;
        for (const glm::uvec3& t : made.triangles)
            sum += double(std::abs(doubled_area(p[t.x], p[t.y], p[t.z])));
        // Where corners are nearly in a line, rounding of the plane may turn them.
        EXPECT_NEAR(sum, double(std::abs(doubled_area(p))), 50.0) << round;
    }
}

TEST(TriangulatePolygon, MakesAFanWhereThereIsNoPlane)
{
    const auto expect_fan = [](const std::vector<glm::vec3>& corner) {
        std::vector<glm::uvec3> triangles;
        EXPECT_TRUE(triangulate_polygon(corner, triangles));
        ASSERT_EQ(triangles.size(), corner.size() - 2);
        for (std::uint32_t k = 0; k < triangles.size(); ++k)
            EXPECT_EQ(triangles[k], glm::uvec3(0, k + 1, k + 2));
    };
    expect_fan(std::vector<glm::vec3>(9, glm::vec3(1, 2, 3)));
    expect_fan({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0.5f, 0.5f, 0.5f}});
    expect_fan({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}); // a bow tie: no area
    expect_fan({{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}, {0.1f, 0.1f, 0}});
    expect_fan({{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}, {0.1f, 0.1f, 0}});
}

TEST(TriangulatePolygon, SaysWhereAnOutlineCrossesItself)
{
    const Cut made = cut({{0, 0}, {10, 10}, {10, 0}, {0, 4}});
    EXPECT_EQ(made.triangles.size(), 2u);
    EXPECT_FALSE(made.sound);
}

TEST(TriangulatePolygon, TakesPolygonsOfTheMostCornersInASecond)
{
    constexpr int kCorners = 65536;
    std::mt19937 random(1);
    Polygon comb, slanted, spiral, tangle, star, same;
    for (int k = 0; k < kCorners / 4; ++k) {
        comb.insert(
            comb.end(), {{2 * k, 3}, {2 * k, 5000 + k % 7}, {2 * k + 1, 5000}, {2 * k + 1, 3}});
        slanted.insert(
            slanted.end(), {{4 * k, -4 * k}, {4 * k + 30000, -4 * k + 30000},
                               {4 * k + 30002, -4 * k + 29998}, {4 * k + 2, -4 * k - 2}});
    }
    comb.insert(comb.end(), {{kCorners, 0}, {0, 0}});
    slanted.insert(slanted.end(), {{kCorners - 40, -kCorners - 40}, {-40, -40}});
    for (int k = 0; k < kCorners / 2; ++k)
        spiral.emplace_back(std::llround((3000 + 9 * k) * std::cos(0.01 * k)),
            std::llround((3000 + 9 * k) * std::sin(0.01 * k)));
    for (int k = kCorners / 2; k-- > 0;)
        spiral.emplace_back(std::llround((1500 + 9 * k) * std::cos(0.01 * k)),
            std::llround((1500 + 9 * k) * std::sin(0.01 * k)));
    for (int k = 0; k < kCorners; ++k) {
        if (k < kCorners / 8) tangle.emplace_back(random() % 100000, random() % 100000);
        if (k < kCorners / 8) same.emplace_back(random() % 3, random() % 3);
        const double r = k % 2 == 0 ? 8e6 : 4e6, angle = 2 * 3.14159265358979 * k / kCorners;
        star.emplace_back(std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle)));
    }
    for (const auto& [polygon, sound] : {std::pair(&comb, true), {&slanted, true}, {&spiral, true},
             {&star, true}, {&tangle, false}, {&same, false}}) {
        const auto start = std::chrono::steady_clock::now();
        const Cut made = cut(*polygon);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), 10); // far more than it takes, for sanitizers and busy machines
        EXPECT_EQ(made.triangles.size(), polygon->size() - 2);
        EXPECT_EQ(made.sound, sound);
        if (!sound) continue;
        const bool turned = doubled_area(*polygon) < 0;
        std::int64_t sum = 0;
        for (const glm::uvec3& t : made.triangles) {
            const std::int64_t area =
                doubled_area((*polygon)[t.x], (*polygon)[t.y], (*polygon)[t.z]);
            EXPECT_TRUE(area == 0 || (area < 0) == turned);
            sum += area;
        }
        EXPECT_EQ(sum, doubled_area(*polygon));
    }
}

} // namespace
} // namespace firsthit::test
