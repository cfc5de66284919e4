// environment_test.cpp - light from all around, against integrals over the sphere.
#include "message_of.h"
#include "shade/plain_shade.h"
#include "shade/tile_scene.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <functional>
#include <limits>
#include <random>

namespace firsthit {
namespace {

using glm::dvec3;

using LightOf = std::function<dvec3(const dvec3&)>;

/// A picture of light from all directions: the middle column along -z, +x to its right.
std::shared_ptr<const EnvironmentMap> picture_of(const LightOf& light, int height)
{
    std::vector<glm::vec3> radiance;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) {
            const double down = std::numbers::pi * (y + 0.5) / height;
            const double around = std::numbers::pi * ((x + 0.5) / height - 1);
            radiance.emplace_back(light(dvec3(std::sin(down) * std::sin(around), std::cos(down),
                -std::sin(down) * std::cos(around))));
        }
    return std::make_shared<EnvironmentMap>("test", 2 * height, height, radiance);
}

/// Calls f(direction, solid angle) for directions all over the sphere.
void for_sphere(const std::function<void(const dvec3&, double)>& f)
{
    constexpr int kRows = 400;
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < 2 * kRows; ++j) {
            const double z = 1 - 2 * (i + 0.5) / kRows, a = std::numbers::pi * (j + 0.5) / kRows;
            const double r = std::sqrt(1 - z * z);
            f({r * std::cos(a), r * std::sin(a), z}, 4 * std::numbers::pi / (2.0 * kRows * kRows));
        }
}

/// Bands up to the second: nine harmonics hold all of it.
dvec3 smooth_light(const dvec3& d)
{
    return {2 + d.x - 0.5 * d.y + d.x * d.z, 1.5 + d.z + 0.5 * (d.x * d.x - d.y * d.y),
        3 + d.y * d.z - d.y + d.x * d.y + 0.3 * d.z * d.z};
}

/// A lamp with soft borders on a dim sky.
dvec3 lamp_light(const dvec3& d)
{
    const double cosine = glm::dot(d, glm::normalize(dvec3(1, 2, 0.5)));
    return dvec3(0.2, 0.3, 0.5) + dvec3(8, 6, 4) / (1 + std::exp(-(cosine - 0.9) * 60));
}

std::vector<dvec3> some_directions(int count)
{
    std::mt19937 random(7);
    std::normal_distribution<double> number;
    std::vector<dvec3> all{{1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}};
    while (int(all.size()) < count) {
        const double x = number(random), y = number(random), z = number(random);
        all.push_back(glm::normalize(dvec3(x, y, z)));
    }
    return all;
}

dvec3 double_of(const scalar::real3& v)
{
    return {v.x, v.y, v.z};
}

double largest(const dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(Environment, DiffuseLightOfASmoothSkyIsTheIntegralOverTheHemisphere)
{
    const auto map = picture_of(smooth_light, 128);
    const ShadeEnvironment shade = shade_environment({.map = map});
    for (const dvec3& n : some_directions(12)) {
        dvec3 sum(0);
        for_sphere([&](const dvec3& d, double angle) {
            sum += smooth_light(d) * (std::max(0.0, glm::dot(n, d)) * angle / std::numbers::pi);
        });
        const dvec3 found = double_of(scalar::environment_diffuse({&shade}, scalar::real_of(n)));
        EXPECT_LT(largest(found - sum), 2e-3) << n.x << " " << n.y << " " << n.z;
    }
}

TEST(Environment, DiffuseLightOfALampStaysWithinTheErrorOfNineHarmonics)
{
    // Ramamoorthi and Hanrahan 2001: the error is at most 9 % of the light that arrives, 3 % on average.
    const auto map = picture_of(lamp_light, 128);
    const ShadeEnvironment shade = shade_environment({.map = map});
    dvec3 all(0);
    for_sphere(
        [&](const dvec3& d, double angle) { all += lamp_light(d) * (angle / std::numbers::pi); });
    for (const dvec3& n : some_directions(12)) {
        dvec3 sum(0);
        for_sphere([&](const dvec3& d, double angle) {
            sum += lamp_light(d) * (std::max(0.0, glm::dot(n, d)) * angle / std::numbers::pi);
        });
        const dvec3 found = double_of(scalar::environment_diffuse({&shade}, scalar::real_of(n)));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], sum[c], 0.09 * all[c]);
    }
}

TEST(Environment, IsSeenAsThePictureSays)
{
    const auto map = picture_of(lamp_light, 256);
    const ShadeEnvironment shade = shade_environment({.map = map});
    for (const dvec3& d : some_directions(500)) {
        const dvec3 found = double_of(scalar::environment_from({&shade}, scalar::real_of(d * 3.0)));
        EXPECT_LT(largest(found - lamp_light(d)), 0.12) << d.x << " " << d.y << " " << d.z;
    }
    // Across the octahedron's edges and through its corners, nothing jumps.
    dvec3 last(0);
    for (int k = 0; k < 4000; ++k) {
        const double a = 2 * std::numbers::pi * k / 4000;
        const dvec3 d(std::cos(a), 0.4 * std::sin(3 * a), std::sin(a));
        const dvec3 found = double_of(scalar::environment_from({&shade}, scalar::real_of(d)));
        EXPECT_LT(k > 0 ? largest(found - last) : 0, 0.35) << k;
        last = found;
    }
}

TEST(Environment, TurnsCounterClockwiseSeenFromAbove)
{
    const auto map =
        picture_of([](const dvec3& d) { return dvec3(d.x > 0.9, d.z < -0.9, 0.5); }, 128);
    const auto from = [&](double angle, const dvec3& d) {
        const ShadeEnvironment shade =
            shade_environment({.map = map, .rotation_rad = angle, .strength = 2});
        return double_of(scalar::environment_from({&shade}, scalar::real_of(d)));
    };
    EXPECT_LT(largest(from(0, {1, 0, 0}) - dvec3(2, 0, 1)), 1e-5);
    EXPECT_LT(largest(from(0, {0, 0, -1}) - dvec3(0, 2, 1)), 1e-5);
    // What was at +x comes from -z, and what was at -z from -x.
    EXPECT_LT(largest(from(std::numbers::pi / 2, {0, 0, -1}) - dvec3(2, 0, 1)), 1e-5);
    EXPECT_LT(largest(from(std::numbers::pi / 2, {-1, 0, 0}) - dvec3(0, 2, 1)), 1e-5);
}

/// The mean of the light around the mirror's direction of a surface that is seen straight, by the weights of
/// the microfacets and of n.l.
dvec3 lobe(const LightOf& light, const dvec3& n, double roughness)
{
    const double a2 = std::pow(roughness, 4);
    dvec3 sum(0);
    double weights = 0;
    for_sphere([&](const dvec3& l, double angle) {
        const double n_l = glm::dot(n, l);
        if (n_l <= 0) return;
        const double n_h = std::sqrt(0.5 * (1 + n_l)); // the eye is at n
        const double bottom = n_h * n_h * (a2 - 1) + 1;
        const double weight = a2 / (bottom * bottom) * n_l * angle;
        sum += light(l) * weight;
        weights += weight;
    });
    return sum / weights;
}

TEST(Environment, SpecularLightIsTheMeanOverTheLobe)
{
    for (const auto& light : {LightOf(smooth_light), LightOf(lamp_light)}) {
        const auto map = picture_of(light, 128);
        const ShadeEnvironment shade = shade_environment({.map = map});
        for (const double roughness : {3.0 / 7, 4.0 / 7, 5.0 / 7, 1.0, 0.64})
            for (const dvec3& n : some_directions(8)) {
                const dvec3 sum = lobe(light, n, roughness);
                const scalar::AroundLight found = scalar::around_light(
                    {&shade}, scalar::real_of(n), scalar::real_of(n), float(roughness));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(double_of(found.specular)[c], sum[c], 0.04 + 0.06 * sum[c])
                        << roughness << " " << n.x << " " << n.y << " " << n.z;
            }
    }
}

/// The share that a white metal, or a dielectric with f0, reflects of an even sky: the integral of the
/// formulas for one light.
double reflected_share(const MetallicRoughness& model, double n_v)
{
    scalar::MapColors maps;
    for (auto& map : maps.map) map = {{1, 1, 1}, 1};
    const auto inputs = scalar::inputs_of(model, maps);
    scalar::Surface surface;
    surface.normal = surface.geometric = {0, 0, 1};
    surface.to_eye = scalar::real_of({std::sqrt(1 - n_v * n_v), 0, n_v});
    double sum = 0;
    for_sphere([&](const dvec3& l, double angle) {
        if (l.z > 0)
            sum += scalar::reflected(inputs, surface, scalar::real_of(l), {1, 1, 1}).x * angle;
    });
    return sum;
}

TEST(Environment, TableHoldsWhatTheFormulasForLightsReflectOfAnEvenSky)
{
    const auto map = constant_environment({1, 1, 1});
    const ShadeEnvironment shade = shade_environment({.map = map});
    for (const double roughness : {0.3, 0.5, 0.8, 1.0})
        for (const double n_v : {0.2, 0.5, 0.9}) {
            const dvec3 v(std::sqrt(1 - n_v * n_v), 0, n_v);
            const scalar::AroundLight found =
                scalar::around_light({&shade}, {0, 0, 1}, scalar::real_of(v), float(roughness));
            for (const float f0 : {1.0f, 0.5f}) {
                const MetallicRoughness metal{
                    .base_color = glm::vec3(f0), .metallic = 1, .roughness = float(roughness)};
                EXPECT_NEAR(f0 * found.per_f0 + found.per_f90, reflected_share(metal, n_v), 0.012)
                    << roughness << " " << n_v << " " << f0;
            }
        }
}

TEST(Environment, AnEvenSkyIsEvenAtEveryRoughness)
{
    const auto map = constant_environment({0.5f, 1, 3});
    const ShadeEnvironment shade = shade_environment({.map = map});
    for (const dvec3& n : some_directions(20))
        for (const float roughness : {0.0f, 0.1f, 0.5f, 1.0f}) {
            const scalar::AroundLight found =
                scalar::around_light({&shade}, scalar::real_of(n), scalar::real_of(n), roughness);
            EXPECT_LT(largest(double_of(found.specular) - dvec3(0.5, 1, 3)), 1e-5);
            EXPECT_LT(largest(double_of(found.diffuse) - dvec3(0.5, 1, 3)), 1e-5);
        }
}

/// The colour of a square in front of the eye, in a white furnace without other lights.
double furnace(const MetallicRoughness& model, const glm::vec3& slope)
{
    TileScene tile(16, 2000);
    tile.scene.environment.map = constant_environment({1, 1, 1});
    tile.add_material<MetallicRoughness>() = model;
    tile.add_square({-100, -100, -10.0f - slope.x * 100 - slope.y * 100}, {200, 0, slope.x * 200},
        {0, 200, slope.y * 200});
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    return memory.targets.color[0][0];
}

TEST(Environment, AWhiteDielectricVanishesInAWhiteFurnace)
{
    for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f})
        for (const float slope : {0.0f, 0.03f, 0.08f})
            EXPECT_NEAR(furnace({.metallic = 0, .roughness = roughness}, {slope, 0, 0}), 1, 1e-4)
                << roughness << " " << slope;
}

TEST(Environment, AWhiteMetalLosesWhatBouncesBetweenMicrofacets)
{
    // Smooth metal reflects all; the roughest loses what is scattered more than once. Straight on and of
    // roughness 1, single scattering leaves 1 - ln 2.
    EXPECT_NEAR(furnace({.metallic = 1, .roughness = 0}, {}), 1, 0.01);
    double last = 1.01;
    for (const float roughness : {0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
        const double share = furnace({.metallic = 1, .roughness = roughness}, {});
        EXPECT_LT(share, last + 1e-4) << roughness;
        last = share;
    }
    EXPECT_NEAR(last, 1 - std::log(2.0), 0.01);
}

TEST(Environment, OcclusionTakesItAwayAndAmbientLightIsNotAddedToIt)
{
    MetallicRoughness model{.metallic = 0.5f, .roughness = 0.5f};
    TileScene tile;
    tile.scene.ambient = {50, 50, 50};
    tile.scene.environment.map = constant_environment({1, 1, 1});
    tile.scene.environment.strength = 0;
    tile.add_material<MetallicRoughness>() = model;
    tile.add_wall();
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(memory.targets.color[0][0], 0);
}

TEST(Environment, PhongAndUnlitDoNotSeeIt)
{
    for (const bool with : {false, true}) {
        TileScene tile;
        tile.add_light({1, 2, 3});
        tile.add_wall();
        if (with) {
            tile.scene.environment.map = constant_environment({5, 5, 5});
            tile.add_material<MetallicRoughness>(); // another material that does
            tile.add_triangle({500, 500, -10}, {501, 500, -10}, {500, 501, -10});
        }
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        static float without = 0;
        if (!with)
            without = memory.targets.color[1][5];
        else
            EXPECT_EQ(memory.targets.color[1][5], without);
    }
}

TEST(Environment, RefusesPicturesOfAWrongSize)
{
    const std::vector<glm::vec3> light(6);
    EXPECT_NE(message_of<ArgumentError>([&] {
        EnvironmentMap("sky", 3, 3, light);
    }).find("6 values for 3 x 3 pixels"),
        std::string::npos);
    EXPECT_NE(message_of<ArgumentError>([&] { EnvironmentMap("sky", 0, 3, light); }).find("0 x 3"),
        std::string::npos);
    EXPECT_THROW(EnvironmentMap("sky", 16384, 16384, light), ArgumentError);
}

TEST(Environment, LightThatIsNoNumberCountsAsNone)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const std::vector<glm::vec3> light{{nan, -1, infinite}};
    const EnvironmentMap map("sky", 1, 1, light);
    EXPECT_NEAR(map.diffuse()[0].x, 0, 1e-6);
    EXPECT_NEAR(map.diffuse()[0].y, 0, 1e-6);
    EXPECT_NEAR(map.diffuse()[0].z / EnvironmentMap::kMaxRadiance, 1, 1e-5);
    for (const glm::vec4& texel : map.texels()) {
        EXPECT_GE(texel.x, 0);
        EXPECT_TRUE(std::isfinite(texel.z));
    }
}

} // namespace
} // namespace firsthit
