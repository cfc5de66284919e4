// far_lamps_test.cpp - lamps that are far from all they light, such as the sun at its place.
#include "cutouts.h"
#include "scenes.h"
#include "shadow/shadow_scenes.h"

#include "exact/shadow_ray.h"
#include "shadow/exact/tile_hull.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit::test {
namespace {

void add_box(TestWorld& world, const glm::vec3& low, const glm::vec3& high)
{
    const auto corner = [&](int k) {
        return glm::vec3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
    };
    const int sides[6][4] = {
        {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (const auto& side : sides) {
        world.add(corner(side[0]), corner(side[1]), corner(side[2]));
        world.add(corner(side[0]), corner(side[2]), corner(side[3]));
    }
}

/// A square kilometre with 64 houses.
TestWorld town()
{
    TestWorld world;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> height(5, 60), side(10, 40);
    world.add({-500, 0, -500}, {-500, 0, 500}, {500, 0, 500});
    world.add({-500, 0, -500}, {500, 0, 500}, {500, 0, -500});
    for (int z = -4; z < 4; ++z)
        for (int x = -4; x < 4; ++x) {
            const glm::vec3 low(float(x) * 110 + 20, 0, float(z) * 110 + 20);
            add_box(world, low, low + glm::vec3(side(random), height(random), side(random)));
        }
    world.finish();
    return world;
}

std::vector<glm::vec3> points_of_town()
{
    std::vector<glm::vec3> points;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> across(-500, 500), up(0.5f, 50);
    for (int k = 0; k < 12000; ++k) points.emplace_back(across(random), up(random), across(random));
    return points;
}

Light lamp_at(const glm::dvec3& position)
{
    Light light;
    light.position = position;
    return light;
}

TEST(FarLamps, LightATownAsTheSunDoes)
{
    const TestWorld world = town();
    const std::vector<glm::vec3> points = points_of_town();
    const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.5, 0.35, 0.8));
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.direction = -to_sun;
    Occlusion occlusion(2);
    std::vector<std::uint8_t> by_sun, by_lamp;
    occlusion.test(world.world, points, sun, by_sun);
    std::size_t dark = 0;
    for (const std::uint8_t value : by_sun) dark += value;
    ASSERT_GT(dark, 1000u);
    ASSERT_LT(dark, 11000u);
    for (const double far : {1e5, 1e6, 1e7, 1e8, 1.5e11, 1e13, 1e29}) {
        Light lamp = lamp_at(to_sun * far);
        for (const bool is_spot : {false, true}) {
            if (is_spot) {
                lamp.kind = Light::Kind::spot;
                lamp.direction = -to_sun;
                lamp.inner_rad = 0.2, lamp.outer_rad = 0.3;
            }
            occlusion.test(world.world, points, lamp, by_lamp);
            std::size_t other = 0;
            for (std::size_t k = 0; k < points.size(); ++k) other += by_sun[k] != by_lamp[k];
            // Shadows of up to 300 m move by up to 300 m * 700 m / far: 2 m, 20 cm, 2 cm ...
            const std::size_t most = std::size_t(12000 * 12 / far * 1e5 / 60) + 2;
            EXPECT_LE(other, far < 1e6 ? 600u : most) << far << (is_spot ? " spot" : "");
        }
    }
}

/// Whether a triangle shadows a point, in long double: 1, 0, or -1 where it is close.
int is_shadowed(const World& world, std::size_t triangle, const glm::vec3& point, const Light& lamp)
{
    using Vector = glm::vec<3, long double>;
    const glm::uvec3& c = world.scene->index[triangle];
    const Vector from(lamp.position), along = Vector(point) - from;
    const Vector p0(world.position[c.x]), e1 = Vector(world.position[c.y]) - p0,
                                          e2 = Vector(world.position[c.z]) - p0;
    const Vector p = glm::cross(along, e2), s = from - p0, q = glm::cross(s, e1);
    const long double det = glm::dot(e1, p);
    if (std::abs(det) < 1e-6L * glm::length(e1) * glm::length(e2) * glm::length(along)) return -1;
    const long double u = glm::dot(s, p) / det, v = glm::dot(along, q) / det,
                      t = glm::dot(e2, q) / det;
    const long double inside = std::min({u, v, 1 - u - v});
    const long double before = (1 - t) * glm::length(along);
    if (std::abs(inside) < 1e-3L || (inside > 0 && std::abs(before) < 1e-2L)) return -1;
    return inside > 0 && t > 0 && before > 0 ? 1 : 0;
}

TEST(FarLamps, ShadowAsRaysFromTheirPlacesDo)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> at(-10, 10), size(-4, 4);
    TestWorld world;
    for (int k = 0; k < 80; ++k) {
        const glm::vec3 p(at(random), at(random), at(random));
        const auto corner = [&] { return p + glm::vec3(size(random), size(random), size(random)); };
        const glm::vec3 a = corner(), b = corner();
        world.add(a, b, corner());
    }
    world.finish();
    std::vector<glm::vec3> points;
    for (int k = 0; k < 4000; ++k) points.emplace_back(at(random), at(random), at(random));
    Occlusion occlusion(2);
    std::vector<std::uint8_t> occluded;
    for (const double far : {300.0, 1000.0, 2e3, 1e5, 1e9}) { // from what is not far to what is
        const Light lamp = lamp_at(glm::normalize(glm::dvec3(-0.3, 0.9, 0.4)) * far);
        occlusion.test(world.world, points, lamp, occluded);
        std::size_t compared = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            int shadowed = 0;
            for (std::size_t t = 0; t < world.scene->index.size() && shadowed >= 0; ++t) {
                const int one = is_shadowed(world.world, t, points[k], lamp);
                shadowed = one < 0 ? -1 : std::max(shadowed, one);
            }
            if (shadowed < 0) continue;
            ++compared;
            ASSERT_EQ(int(occluded[k]), shadowed) << "point " << k << ", " << far;
        }
        EXPECT_GT(compared, 2000u);
    }
}

TEST(FarLamps, AreSeenAsDirectionalFromAfarOnly)
{
    const std::vector<glm::vec3> points{{1, 0, 0}, {0, -2, 0}};
    EXPECT_EQ(farthest_coordinate(lamp_at({200, 0, 0}), points), 2.0f);
    EXPECT_TRUE(std::isinf(farthest_coordinate(lamp_at({100, 0, 0}), points)));
    EXPECT_TRUE(light_space(lamp_at({200, 0, 0}), {}, 2).directional);
    EXPECT_FALSE(light_space(lamp_at({100, 0, 0}), {}, 2).directional);
    EXPECT_FALSE(light_space(lamp_at({1e9, 0, 0}), {}).directional);
}

/// Also with triangles that let some of their points out.
TEST(FarLamps, PicturesEqualBruteForce)
{
    const double distances[] = {100, 1e4, 1e9};
    std::size_t number = 0, tested = 0;
    for (const ShadowScene& scene : shadow_scenes()) {
        ShadowWorld made = make_shadow_world(scene, 5);
        World& world = made.world.world;
        const double size = double(largest_coordinate(world.position));
        if (!(size < 1e20)) continue;
        std::mt19937 random(1);
        const double far = distances[number % 3] * size;
        if (number++ % 2 == 1) make_cutouts(made.world, random, true);
        for (Light& light : world.lights) {
            const glm::dvec3 to(double(random() % 100) - 50, double(random() % 100) + 1,
                double(random() % 100) - 50);
            light = lamp_at(glm::normalize(to) * far);
        }
        const LitComparison c = compare_lit(world, made.view, Oracle::brute, 2);
        EXPECT_EQ(c.ours_wrong, 0u) << scene.name << " " << far;
        EXPECT_EQ(c.theirs_wrong, 0u) << scene.name << " " << far;
        ++tested;
    }
    EXPECT_GT(tested, 3u);
}

/// The holes of a leaf are where the sun's light finds them.
TEST(FarLamps, ShineThroughHolesAsTheSunDoes)
{
    TestWorld world;
    world.add({-8, 5, -9}, {-7, 5, 9}, {9, 6, 8}); // the leaf: a slanted triangle
    world.add({-20, 0, -20}, {-20, 0, 20}, {20, 0, 0});
    world.finish();
    Scene& scene = *world.scene;
    std::vector<int> alphas;
    for (int k = 0; k < 64; ++k) alphas.push_back((k / 8 + k) % 3 == 0 ? 0 : 255);
    scene.textures = {alpha_texture(8, 8, alphas)};
    scene.uv = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 0}, {0, 0}};
    Material leaf;
    leaf.alpha = AlphaMode::mask;
    leaf.opacity_texture.texture = 0;
    scene.materials = {leaf, Material{}};
    Instance first = scene.instances[0], second = first;
    first.triangle_count = second.triangle_count = 1;
    second.first_triangle = second.material = 1;
    scene.instances = {first, second};
    scene.owner = {0, 1};
    std::vector<glm::vec3> points;
    for (int z = -40; z < 40; ++z)
        for (int x = -40; x < 40; ++x)
            points.emplace_back(float(x) * 0.25f + 0.01f, 0.5f, float(z) * 0.25f + 0.02f);
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.direction = {-0.3, -1, -0.2};
    Occlusion occlusion(1);
    std::vector<std::uint8_t> by_sun, by_lamp;
    occlusion.test(world.world, points, sun, by_sun);
    for (const double far : {1e5, 1e9}) {
        occlusion.test(world.world, points, lamp_at(-sun.direction * far), by_lamp);
        std::size_t other = 0, dark = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            other += by_sun[k] != by_lamp[k];
            dark += by_sun[k];
        }
        EXPECT_GT(dark, 300u);
        EXPECT_LT(dark, 3000u);
        EXPECT_LE(other, 8u) << far;
    }
}

} // namespace
} // namespace firsthit::test
