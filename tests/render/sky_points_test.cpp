// sky_points_test.cpp - the light of the sky at any points, against rays and against pictures.
#include "sky_scene.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit::test {
namespace {

/// Whether a ray hits the triangle, in double, the usual way (Möller and Trumbore 1997).
bool ray_hits(const glm::dvec3& from, const glm::dvec3& d, const glm::dvec3 (&v)[3])
{
    const glm::dvec3 e1 = v[1] - v[0], e2 = v[2] - v[0], p = glm::cross(d, e2);
    const double det = glm::dot(e1, p);
    if (det == 0) return false;
    const glm::dvec3 s = from - v[0], q = glm::cross(s, e1);
    const double b = glm::dot(s, p) / det, c = glm::dot(d, q) / det;
    return b >= 0 && c >= 0 && b + c <= 1 && glm::dot(e2, q) / det > 0;
}

TEST(Sky, AtPointsEqualsRays)
{
    const SkyScene scene(10);
    const World& world = scene.world.world;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<glm::vec3> positions, normals;
    for (int k = 0; k < 700; ++k) {
        positions.emplace_back(8 * unit(random) - 4, 8 * unit(random) - 4, 3 * unit(random));
        normals.push_back(glm::normalize(
            glm::vec3(unit(random) - 0.5f, unit(random) - 0.5f, unit(random) - 0.4f)));
    }
    Sky sky = sky_settings(21).sky;
    sky.up = {0.2, -0.1, 1};
    Occlusion occlusion(2);
    std::vector<glm::vec3> light;
    sky_light(occlusion, world, sky, {positions, normals, {}}, light);
    const glm::dvec3 up = glm::normalize(sky.up);
    std::size_t wrong = 0, dark = 0;
    for (std::size_t k = 0; k < positions.size(); ++k) {
        double open = 0, seen = 0, full = 0;
        for (const glm::dvec3& w : sky_directions(21, sky.up)) {
            full += glm::dot(w, up);
            const double cosine = std::max(0.0, glm::dot(glm::dvec3(normals[k]), w));
            open += cosine;
            bool hidden = false;
            for (const glm::uvec3& c : world.scene->index)
                hidden =
                    hidden || ray_hits(glm::dvec3(positions[k]), w,
                                  {glm::dvec3(world.position[c.x]), glm::dvec3(world.position[c.y]),
                                      glm::dvec3(world.position[c.z])});
            if (!hidden) seen += cosine;
        }
        const double rest = 0.02 * full;
        const double expected =
            0.25 * seen / full + 0.125 * (0.5 - 0.5 * glm::dot(glm::dvec3(normals[k]), up)) *
                                     (seen + rest) / (open + rest);
        wrong += std::abs(light[k].x - expected) > 1e-5;
        dark += seen < 0.5 * open;
    }
    EXPECT_LE(wrong, 2u) << "rays that pass an edge by rounding";
    EXPECT_GT(dark, 50u);
}

TEST(Sky, AtPointsOfSurfacesIsThatOfThePicture)
{
    const SkyScene scene(11);
    Settings settings = sky_settings(14);
    settings.sky.up = {0, 0.3, 1};
    settings.aovs = {Aov::item, Aov::position, Aov::normal};
    scene.world.scene->materials[0].model = Phong{.ambient = glm::vec3(0), .diffuse = glm::vec3(1)};
    const Film film = scene.render(settings);
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> receivers;
    std::vector<std::size_t> pixels;
    for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
        if (film.item[pixel] == kNoItem) continue;
        positions.push_back(at(film[Aov::position], pixel));
        normals.push_back(at(film[Aov::normal], pixel));
        receivers.push_back(film.item[pixel]);
        pixels.push_back(pixel);
    }
    Occlusion occlusion(2);
    std::vector<glm::vec3> light;
    sky_light(occlusion, scene.world.world, settings.sky, {positions, normals, receivers}, light);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < light.size(); ++k)
        wrong += glm::distance(light[k], at(film.color, pixels[k])) > 1e-5f;
    // Margins of shadows hold the eye's coordinates in a picture, and not at points.
    EXPECT_LE(wrong, light.size() / 1000);
}
} // namespace
} // namespace firsthit::test
