// resolve_tile_test.cpp - depth and barycentrics against long double arithmetic.
#include "cpu/adversarial_scenes.h"
#include "items.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace firsthit::test {
namespace {

using Real = long double;

struct Exact {
    Real t, u, v;
};

/// The hit in 64-bit mantissas from exact float corners.
Exact exact_hit(const Corners& c, const glm::vec3& d)
{
    const auto edge = [&](const glm::vec3& a, const glm::vec3& b) {
        return Real(d.x) * (Real(a.y) * b.z - Real(a.z) * b.y) +
               Real(d.y) * (Real(a.z) * b.x - Real(a.x) * b.z) +
               Real(d.z) * (Real(a.x) * b.y - Real(a.y) * b.x);
    };
    const Real e0 = edge(c[1], c[2]), e1 = edge(c[2], c[0]), e2 = edge(c[0], c[1]);
    const Real det = e0 + e1 + e2;
    const glm::vec3 &a = c[1], &b = c[2];
    const Real volume = Real(c[0].x) * (Real(a.y) * b.z - Real(a.z) * b.y) +
                        Real(c[0].y) * (Real(a.z) * b.x - Real(a.x) * b.z) +
                        Real(c[0].z) * (Real(a.x) * b.y - Real(a.y) * b.x);
    return {volume / det, e1 / det, e2 / det};
}

float units_in_last_place(float value, Real exact)
{
    const float step = std::nextafter(std::abs(value), INFINITY) - std::abs(value);
    return float(std::abs(Real(value) - exact) / Real(step));
}

TEST(ResolveTile, DepthIsWithinOneUnitInTheLastPlaceOfAPlanes)
{
    // Planes from 0.01 to 1000 away, facing the eye or tilted.
    const View view = straight_view(64, 64, 64);
    for (const float z : {0.01f, 0.1f, 0.7f, 3.0f, 40.0f, 1000.0f}) {
        for (const float tilt : {0.0f, 0.3f, -0.9f}) {
            TestWorld world;
            const auto p = [&](float x, float y) {
                return glm::vec3(x * z, y * z, z * (1 + tilt * x));
            };
            world.add(p(-9, -9), p(9, -9), p(0, 9));
            world.finish();
            const Rendered r = render_planes(world.world, view, {Aov::depth});
            const EyeWorld eye(world.world, view);
            for (int y = 0; y < 64; ++y) {
                for (int x = 0; x < 64; ++x) {
                    const float depth = r.film[Aov::depth].value[std::size_t(y * 64 + x)];
                    if (!std::isfinite(depth)) continue;
                    const Exact exact = exact_hit(eye.triangles[0], eye.ray(x, y));
                    EXPECT_LE(units_in_last_place(depth, exact.t), 1) << z << " " << tilt;
                }
            }
        }
    }
}

TEST(ResolveTile, HitsEveryItemOfEveryAdversarialScene)
{
    const View view = straight_view(kSize, kSize, kSize);
    for (const AdversarialScene& scene : adversarial_scenes()) {
        SCOPED_TRACE(scene.name);
        std::mt19937 random(4);
        TestWorld world;
        scene.fill(world, random);
        world.finish();
        const Rendered r = render_planes(
            world.world, view, {Aov::item, Aov::depth, Aov::distance, Aov::barycentric});
        const EyeWorld eye(world.world, view);
        for (std::size_t i = 0; i < r.film.item.size(); ++i) {
            const float depth = r.film[Aov::depth].value[i],
                        u = r.film[Aov::barycentric].value[2 * i],
                        v = r.film[Aov::barycentric].value[2 * i + 1];
            if (r.film.item[i] == kNoItem) {
                EXPECT_EQ(depth, INFINITY);
                EXPECT_EQ(u, 0);
                continue;
            }
            const Corners c = eye.triangles[r.film.item[i]];
            const float nearest = std::min({c[0].z, c[1].z, c[2].z});
            const float farthest = std::max({c[0].z, c[1].z, c[2].z});
            EXPECT_GT(depth, 0);
            EXPECT_GE(depth, nearest - 1e-6f * std::abs(nearest));
            EXPECT_LE(depth, farthest * (1 + 1e-6f));
            EXPECT_TRUE(u >= 0 && v >= 0 && u + v <= 1.000001f) << u << " " << v;
            EXPECT_GE(r.film[Aov::distance].value[i], depth * 0.999999f);
        }
    }
}

TEST(ResolveTile, BarycentricsAreEmbreesWeightsOfCornersOneAndTwo)
{
    TestWorld world;
    const glm::vec3 a(-3, -2, 5), b(4, -1, 6), c(0.5f, 3, 7);
    world.add(a, b, c);
    world.finish();
    const View view = straight_view(32, 32, 32);
    const Rendered r = render_planes(world.world, view, {Aov::item, Aov::depth, Aov::barycentric});
    int hits = 0;
    for (std::size_t i = 0; i < r.film.item.size(); ++i) {
        if (r.film.item[i] == kNoItem) continue;
        ++hits;
        const float u = r.film[Aov::barycentric].value[2 * i],
                    v = r.film[Aov::barycentric].value[2 * i + 1];
        const glm::vec3 p = (1 - u - v) * a + u * b + v * c;
        const float t = r.film[Aov::depth].value[i];
        EXPECT_NEAR(p.z, t, 1e-5);
        EXPECT_NEAR(p.x, (float(i % 32) + .5f - 16) / 32 * t, 1e-5);
        EXPECT_NEAR(p.y, (float(i / 32) + .5f - 16) / 32 * t, 1e-5);
    }
    EXPECT_GT(hits, 100);
}

TEST(ResolveTile, BoundariesOfACheckerboardLieWhereProjectionPutsThem)
{
    // A tilted board of 12 x 9 squares: each pixel's square is the one that the double-precision
    // ray meets, except within a millionth of a pixel of a line.
    const View view = straight_view(320, 240, 300);
    const glm::dvec3 corner(-0.61, -0.37, 1.5), along(0.1, 0.012, 0.03), down(-0.008, 0.09, 0.02);
    TestWorld world;
    for (int j = 0; j <= 9; ++j)
        for (int i = 0; i <= 12; ++i)
            world.world.position.push_back(
                glm::vec3(corner + double(i) * along + double(j) * down));
    for (std::uint32_t j = 0; j < 9; ++j) {
        for (std::uint32_t i = 0; i < 12; ++i) {
            const std::uint32_t a = j * 13 + i, c = a + 13;
            world.scene->index.push_back({a, a + 1, c + 1});
            world.scene->index.push_back({a, c + 1, c});
        }
    }
    world.finish();
    const auto items = items_of(world.world, view);
    const glm::dvec3 normal = glm::cross(along, down);
    int checked_pixels = 0;
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            const glm::dvec3 d((x + 0.5 - 160) / 300, (y + 0.5 - 120) / 300, 1);
            const glm::dvec3 p = glm::dot(normal, corner) / glm::dot(normal, d) * d - corner;
            const double i = glm::dot(glm::cross(p, down), normal) / glm::dot(normal, normal);
            const double j = glm::dot(glm::cross(along, p), normal) / glm::dot(normal, normal);
            // A square is about 20 pixels wide; the board's own corners are rounded to float.
            const double margin = 1e-6;
            if (std::abs(i - std::round(i)) < margin || std::abs(j - std::round(j)) < margin)
                continue;
            const bool inside = i > 0 && i < 12 && j > 0 && j < 9;
            const std::uint32_t item = items[std::size_t(y * 320 + x)];
            ASSERT_EQ(item != kNoItem, inside) << x << " " << y;
            if (!inside) continue;
            EXPECT_EQ(item / 2, std::uint32_t(j) * 12 + std::uint32_t(i)) << x << " " << y;
            ++checked_pixels;
        }
    }
    EXPECT_GT(checked_pixels, 10000);
}

} // namespace
} // namespace firsthit::test
