// metallic_roughness_test.cpp - the model of glTF 2.0 against the formulas of its specification.
#include "shade/plain_shade.h"
#include "shade/tile_scene.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace firsthit {
namespace {

using glm::dvec3;

/// What a surface is at a point, textures and all.
struct Point {
    dvec3 base{1};
    double metallic = 0, roughness = 1;
    dvec3 f0{0.04};
    double specular = 1;
};

/// Light that goes to the eye of light with irradiance 1 on a surface straight below it, by appendix B of the
/// specification and KHR_materials_specular, term by term.
dvec3 by_specification(const Point& p, const dvec3& n, const dvec3& v, const dvec3& l)
{
    const double n_l = glm::dot(n, l), n_v = glm::dot(n, v);
    if (n_l <= 0 || n_v <= 0) return dvec3(0);
    const dvec3 h = glm::normalize(l + v);
    const double n_h = glm::dot(n, h), v_h = glm::dot(v, h);
    const double a = p.roughness * p.roughness, a2 = a * a;
    const double bottom = n_h * n_h * (a2 - 1) + 1;
    const double d = a2 / (std::numbers::pi * bottom * bottom);
    const auto g1 = [&](double x) { return 2 * x / (x + std::sqrt(a2 + (1 - a2) * x * x)); };
    const double specular_brdf = g1(n_l) * g1(n_v) * d / (4 * n_l * n_v);
    const double w = std::pow(1 - std::abs(v_h), 5);

    const dvec3 metal = specular_brdf * (p.base + (dvec3(1) - p.base) * w);
    const dvec3 f0 = glm::min(p.f0, dvec3(1)) * p.specular;
    const dvec3 f = f0 + (dvec3(p.specular) - f0) * w;
    const dvec3 dielectric =
        (1 - std::max({f.x, f.y, f.z})) * p.base / std::numbers::pi + specular_brdf * f;
    return (dielectric + (metal - dielectric) * p.metallic) * n_l;
}

/// The model's text.
dvec3 by_text(const Point& p, const dvec3& n, const dvec3& v, const dvec3& l)
{
    const MetallicRoughness model{.base_color = p.base,
        .metallic = float(p.metallic),
        .roughness = float(p.roughness),
        .f0 = p.f0,
        .specular = float(p.specular)};
    scalar::MapColors maps;
    for (scalar::MapColor& map : maps.map) map = {{1, 1, 1}, 1};
    scalar::Surface surface{};
    surface.normal = scalar::real_of(n);
    surface.to_eye = scalar::real_of(v);
    const scalar::real3 light =
        scalar::reflected(scalar::inputs_of(model, maps), surface, scalar::real_of(l), {1, 1, 1});
    return {light.x, light.y, light.z};
}

class Random {
  public:
    double number(double low = 0, double high = 1)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    dvec3 direction()
    {
        for (;;) {
            const dvec3 d(number(-1, 1), number(-1, 1), number(-1, 1));
            if (const double length = glm::length(d); length > 0.1 && length < 1) return d / length;
        }
    }
    dvec3 color(double most = 1) { return {number(0, most), number(0, most), number(0, most)}; }

  private:
    std::mt19937 engine_{1};
};

TEST(MetallicRoughness, IsTheFormulaOfTheSpecification)
{
    Random random;
    int lit = 0;
    for (int k = 0; k < 20000; ++k) {
        Point p{random.color(), random.number(), random.number(0.05, 1), random.color(1.5),
            random.number()};
        const dvec3 n = random.direction();
        dvec3 v = random.direction();
        if (glm::dot(v, n) < 0) v = -v;
        dvec3 l = random.direction();
        // Half of them within the highlight.
        if (k % 2) l = glm::normalize(2 * glm::dot(n, v) * n - v + 0.2 * p.roughness * l);
        const dvec3 expected = by_specification(p, n, v, l), found = by_text(p, n, v, l);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(found[c], expected[c], 2e-6 + 1e-3 * expected[c])
                << k << ": roughness " << p.roughness << ", n.v " << glm::dot(n, v) << ", n.l "
                << glm::dot(n, l);
        lit += expected.x > 0;
    }
    EXPECT_GT(lit, 10000);
}

TEST(MetallicRoughness, HasALeastRoughness)
{
    const dvec3 n(0, 0, 1);
    const dvec3 v = glm::normalize(dvec3(0.3, 0, 1));
    for (const double tilt : {0.0, 0.001, 0.01}) {
        const dvec3 l = glm::normalize(dvec3(-0.3 + tilt, tilt, 1));
        Point mirror{dvec3(1), 1, 0};
        const dvec3 found = by_text(mirror, n, v, l);
        mirror.roughness = 0.045;
        EXPECT_NEAR(found.x, by_specification(mirror, n, v, l).x, 1e-3 * found.x);
    }
    // Against the light, and along the surface: numbers, not infinite.
    for (const dvec3& l : {-v, dvec3(1, 0, 0), dvec3(0, 0, -1), v})
        for (const dvec3& to_eye : {v, dvec3(1, 0, 0), dvec3(-1, 0, 0)}) {
            const dvec3 found = by_text({dvec3(1), 0.5, 0}, n, to_eye, l);
            EXPECT_TRUE(std::isfinite(found.x) && found.x >= 0) << found.x;
        }
}

/// White surfaces in white light from all sides send no more than they get; but that the specification weighs
/// what a dielectric's base gets by the microfacet's angle, which at grazing angles is too much.
TEST(MetallicRoughness, KeepsEnergy)
{
    constexpr int kSteps = 300;
    for (const double metallic : {0.0, 0.5, 1.0})
        for (const double roughness : {0.3, 0.6, 1.0})
            for (const double tilt : {0.05, 0.8, 1.4}) {
                const dvec3 n(0, 0, 1), v(std::sin(tilt), 0, std::cos(tilt));
                const Point white{dvec3(1), metallic, roughness};
                double sum = 0;
                for (int i = 0; i < kSteps; ++i)
                    for (int j = 0; j < kSteps; ++j) {
                        const double angle = (i + 0.5) / kSteps * std::numbers::pi / 2;
                        const double around = (j + 0.5) / kSteps * 2 * std::numbers::pi;
                        const dvec3 l(std::sin(angle) * std::cos(around),
                            std::sin(angle) * std::sin(around), std::cos(angle));
                        sum += by_text(white, n, v, l).x * std::sin(angle);
                    }
                sum *= std::numbers::pi / 2 * 2 * std::numbers::pi / (double(kSteps) * kSteps);
                const bool too_much = metallic < 1 && tilt > 1;
                EXPECT_LT(sum, too_much ? 1.25 : 1.005)
                    << metallic << " " << roughness << " " << tilt;
                EXPECT_GT(sum, 0.3) << metallic << " " << roughness << " " << tilt;
            }
}

TEST(MetallicRoughness, GlowsAndReflectsAmbientLight)
{
    for (const float metallic : {0.0f, 1.0f}) {
        TileScene tile;
        tile.scene.ambient = {1, 2, 0.5f};
        auto& model = tile.add_material<MetallicRoughness>();
        model.base_color = {0.5f, 0.25f, 1};
        model.emission = {3, 0, 0.125f};
        model.metallic = metallic;
        tile.add_wall();
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        const glm::vec3 color = at(memory.targets.color, 3, 4, tile.hits.size);
        EXPECT_NEAR(color.r, 3.05f, 1e-6f);
        EXPECT_NEAR(color.g, 0.05f, 1e-7f);
        EXPECT_NEAR(color.b, 0.175f, 1e-7f);
        EXPECT_EQ(at(memory.targets.albedo, 3, 4, tile.hits.size), model.base_color);
    }
}

/// All at once, over a picture, from the hits' own positions.
TEST(MetallicRoughness, ShadesPictures)
{
    Random random;
    for (int k = 0; k < 20; ++k) {
        const Point p{random.color(), random.number(), random.number(0.2, 1), random.color(),
            random.number()};
        TileScene tile;
        tile.scene.ambient = {0, 0, 0};
        tile.add_material<MetallicRoughness>() = {.base_color = p.base,
            .metallic = float(p.metallic),
            .roughness = float(p.roughness),
            .f0 = p.f0,
            .specular = float(p.specular)};
        tile.add_square({-100, -80, -20}, {200, 20, 3}, {5, 160, -2});
        const dvec3 lamp(3, 2, random.number(-9, 5));
        tile.add_light(lamp, {2, 3, 4});
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        const dvec3 n(tile.world.normal[0]);
        for (int y = 0; y < tile.hits.size; y += 3)
            for (int x = 0; x < tile.hits.size; x += 3) {
                const dvec3 point = tile.direction(x, y) * tile.meet(0, x, y).x;
                const dvec3 expected =
                    by_specification(p, n, glm::normalize(-point), glm::normalize(lamp - point)) *
                    dvec3(2, 3, 4);
                const glm::vec3 found = at(memory.targets.color, x, y, tile.hits.size);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[c], expected[c], 1e-5 + 1e-3 * expected[c]) << x << " " << y;
            }
    }
}

} // namespace
} // namespace firsthit
