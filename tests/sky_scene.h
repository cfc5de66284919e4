// sky_scene.h - a scene with hollows, and pictures of it under a sky.
#pragma once

#include "scenes.h"

#include <firsthit/firsthit.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace firsthit::test {

inline constexpr glm::vec3 kSkyBlue(0.25f, 0.5f, 1.0f);
inline constexpr std::size_t kMiddle = 28 * 72 + 36; // pixel of the pictures below

/// Boxes on a floor, and crossing ones, in random places: z is up, and the eye looks down at them.
struct SkyScene {
    TestWorld world;
    View view;

    explicit SkyScene(unsigned seed, int boxes = 12)
    {
        quad({-8, -8, 0}, {16, 0, 0}, {0, 16, 0});
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int k = 0; k < boxes; ++k) {
            const glm::vec3 size(0.4f + unit(random), 0.4f + unit(random), 0.4f + 3 * unit(random));
            box({8 * unit(random) - 4, 8 * unit(random) - 4, 0.37f * unit(random)}, size,
                unit(random) * 3);
        }
        world.finish();
        matt({1, 0.75f, 0.5f});
        view.width = 72, view.height = 56;
        view.camera.eye = {1.5, -11, 9};
        view.camera.direction = glm::dvec3(0, 0, 0.5) - view.camera.eye;
        view.camera.up = {0.1, 0, 1};
    }

    void quad(const glm::vec3& at, const glm::vec3& a, const glm::vec3& b)
    {
        world.add(at, at + a, at + a + b);
        world.add(at, at + a + b, at + b);
    }

    void box(const glm::vec3& at, const glm::vec3& size, float turn)
    {
        const glm::vec3 x(std::cos(turn) * size.x, std::sin(turn) * size.x, 0);
        const glm::vec3 y(-std::sin(turn) * size.y, std::cos(turn) * size.y, 0), z(0, 0, size.z);
        quad(at, x, y), quad(at + z, x, y), quad(at, x, z), quad(at + y, x, z), quad(at, y, z),
            quad(at + x, y, z);
    }

    /// All surfaces are matt, and there are no normals but those of the planes.
    void matt(const glm::vec3& color)
    {
        Phong phong;
        phong.ambient = glm::vec3(0);
        phong.diffuse = color;
        world.scene->materials[0].model = phong;
        world.scene->normal.clear();
        world.world.normal.clear();
    }

    Film render(const Settings& settings, int threads = 2) const
    {
        Film film;
        Renderer(threads).render(world.world, view, settings, film);
        return film;
    }
};

inline Settings sky_settings(int directions)
{
    Settings settings;
    settings.sky = {.directions = directions, .color = kSkyBlue, .ground = glm::vec3(0.125f)};
    return settings;
}

inline glm::vec3 at(const Plane& plane, std::size_t pixel)
{
    return {plane.value[3 * pixel], plane.value[3 * pixel + 1], plane.value[3 * pixel + 2]};
}

} // namespace firsthit::test
