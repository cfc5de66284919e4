// shadow_scenes.cpp - adversarial scenes: their shadows are wrong if they are not computed exactly.
#include "shadow/shadow_scenes.h"

#include "shadow/shadow_builder.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace firsthit::test {
namespace {

using glm::dvec3;
using glm::vec3;

void box_on_floor(Builder& b)
{
    b.floor();
    b.box({-0.5f, 0, -0.25f}, {0.5f, 0.75f, 0.5f});
    b.sphere({1.2f, 0.4f, 0.3f}, 0.4f, 12);
    b.light(point_light({1.7, 2.3, 1.1}));
    b.light(directional_light({-1, -1.5, 0.5}));
    b.light(spot_light({-1, 3, 1}, {0.3, -1, -0.3}, 0.5));
    b.eye({2, 3, 4});
}

void add_everyday(Scenes& scenes)
{
    add(scenes, "a box on a floor", box_on_floor);
    add(scenes, "two spheres 4e-5 apart", [](Builder& b) {
        b.sphere({0, -1, 0}, 1);
        b.sphere({0, 1 + 4e-5f, 0}, 1);
        b.light(point_light({0, 4, 0}));
        b.light(point_light({1.5, 3.5, 0.5}));
        b.light(directional_light({0, -1, 0}));
        b.eye({0.5, -0.1, 2.5});
    });
    add(scenes, "light inside a closed box", [](Builder& b) {
        b.box(vec3(-2), vec3(2));
        for (int k = 0; k < 12; ++k) {
            const vec3 p = random_point(b.random, 1.5f), half(uniform(b.random, 0.05f, 0.2f));
            b.box(p - half, p + half);
        }
        b.light(point_light({0, 0, 0}));
        b.light(point_light({0.3, -0.7, 1.9}));
        b.light(spot_light({1.5, 1.5, -1.5}, {-1, -1, 1}, 0.7));
        b.eye({-1.7, 1.6, 1.7}, {0.5, -0.5, -0.5});
        b.made.view.camera.fov_y_rad = 1.8;
    });
    add(scenes, "a smooth ball where the light grazes", [](Builder& b) {
        b.sphere(vec3(0), 1, 48);
        b.light(directional_light({-1, -0.4, 0.1}));
        b.light(point_light({3, 0.2, 1}));
        b.eye({0, 1, 3});
    });
    add(scenes, "spots", [](Builder& b) {
        b.floor();
        for (int k = 0; k < 6; ++k) {
            const vec3 p = random_point(b.random, 1.5f);
            b.box(p + vec3(-0.2f, 1, -0.2f), p + vec3(0.2f, 1.2f, 0.2f));
        }
        for (const double outer : {0.01, 0.3, 1.0, 1.5})
            b.light(spot_light({0.3, 2.9, -0.2}, {0.1, -1, 0.2}, outer));
        b.light(spot_light({0, 3, 0}, {0, 1, 0}, 0.5)); // shines away from the scene
        b.eye({1, 5, 3});
    });
}

void add_exact(Scenes& scenes)
{
    add(scenes, "coplanar receivers and occluders", [](Builder& b) {
        // Points with few bits on x / 4 + z / 8 + y = 0 lie exactly in one plane.
        for (int k = 0; k < 120; ++k) {
            const auto p = [&] {
                const float x = float(whole(b.random, -32, 32)) / 16,
                            z = float(whole(b.random, -32, 32)) / 16;
                return vec3(x, -x / 4 - z / 8, z);
            };
            b.triangle(p(), p(), p());
        }
        b.light(point_light({0.5, 2, 0.25}));
        b.light(directional_light({1, -2, 0.5}));
        b.light(point_light({1, -0.25, 0})); // in the plane
        b.eye({0.5, 3, 2});
    });
    add(scenes, "lights in the planes of triangles", [](Builder& b) {
        b.floor(-1);
        const vec3 light(0.5f, 2, 0.25f);
        for (int k = 0; k < 60; ++k) {
            const vec3 p = whole_point(b.random, 8) / 8.0f, q = whole_point(b.random, 8) / 8.0f;
            const float off = k % 3 == 0 ? 0.0f : uniform(b.random, -1e-6f, 1e-6f);
            b.triangle(p, q, light + 2.0f * (p - light) - (q - light) + vec3(0, off, 0));
        }
        b.quad({-1, 0, 0.25f}, {1, 0, 0.25f}, {1, 1, 0.25f}, {-1, 1, 0.25f});
        b.light(point_light(light));
        b.light(directional_light({0, -1, 0})); // in the plane of the wall
        b.light(directional_light({1, -1, 0}));
        b.eye({2, 3, 3});
    });
    add(scenes, "a light on a vertex", [](Builder& b) {
        b.floor(-1);
        for (int k = 0; k < 12; ++k)
            b.triangle({0.25f, 1, 0.5f}, random_point(b.random), random_point(b.random));
        b.light(point_light({0.25, 1, 0.5}));
        b.light(point_light(dvec3(b.made.world.world.position[8])));
        b.eye({2, 2, 3});
    });
    add(scenes, "a light in the surface that is seen", [](Builder& b) {
        b.floor(0, 3, 7);
        b.box({-0.5f, 0.25f, -0.5f}, {0.5f, 0.5f, 0.5f});
        b.light(point_light({0.7, 0, 0.9}));
        b.light(point_light({0.7, 1e-4, 0.9}));
        b.light(point_light({0.1, 0.5, 0.2}));
        b.eye({1, 2, 3});
    });
    add(scenes, "duplicates and permuted duplicates", [](Builder& b) {
        for (int k = 0; k < 30; ++k) {
            std::array<vec3, 3> p{
                random_point(b.random), random_point(b.random), random_point(b.random)};
            for (int copy = 0; copy < 4; ++copy) {
                std::shuffle(p.begin(), p.end(), b.random);
                b.triangle(p[0], p[1], p[2]);
            }
        }
        std::shuffle(b.made.world.scene->index.begin(), b.made.world.scene->index.end(), b.random);
        b.some_lights();
        b.eye({0, 1, 4});
    });
    add(scenes, "vertices and edges on shadow rays", [](Builder& b) {
        // All coordinates have few bits, so that many edge functions are exactly zero.
        b.floor(-1, 4, 8);
        for (int layer = 0; layer < 3; ++layer) {
            const float t = 0.25f * float(layer + 1); // from the light (0, 3, 0) to the floor
            b.grid(4, [&](int i, int j) {
                return vec3(t * float(2 * i - 4), 3 - 4 * t, t * float(2 * j - 4));
            });
            for (int k = 0; k < 20; ++k) b.made.world.scene->index.pop_back();
        }
        b.light(point_light({0, 3, 0}));
        b.light(directional_light({0, -1, 0}));
        b.light(directional_light({1, -1, 0}));
        b.light(directional_light({1, -2, 1}));
        b.eye({0, 6, 5}, {0, -1, 0});
    });
    add(scenes, "whole coordinates", [](Builder& b) {
        for (int k = 0; k < 150; ++k)
            b.triangle(0.5f * whole_point(b.random, 3), 0.5f * whole_point(b.random, 3),
                0.5f * whole_point(b.random, 3));
        b.light(point_light({0, 3, 0}));
        b.light(point_light({0.5, 0.5, 0.5}));
        for (const auto& way : {dvec3(0, -1, 0), dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(1, 1, 1)})
            b.light(directional_light(way));
        b.eye({1, 2, 5});
    });
}

void add_thin(Scenes& scenes)
{
    add(scenes, "fans of needles", [](Builder& b) {
        b.floor(-1);
        for (const vec3& hub : {vec3(0, 0.5f, 0), vec3(0.1f, 0.8f, -0.3f)}) {
            const int n = 600;
            const auto rim = [&](int k) {
                const float a = 6.2831853f * float(k % n) / float(n);
                return hub + 0.8f * vec3(std::cos(a), 0.1f * std::sin(7 * a), std::sin(a));
            };
            for (int k = 0; k < n; ++k) b.triangle(hub, rim(k), rim(k + 1));
        }
        b.some_lights();
        b.light(directional_light({0, -1, 0}));
        b.eye({1.5, 2, 2.5});
    });
    add(scenes, "slivers", [](Builder& b) {
        b.floor(-1);
        for (int k = 0; k < 300; ++k) {
            const vec3 p = random_point(b.random), q = random_point(b.random);
            b.triangle(p, q,
                p + (q - p) * uniform(b.random, 0, 1) + vec3(uniform(b.random, -1e-5f, 1e-5f)));
        }
        b.some_lights();
        b.eye({1, 2, 3});
    });
    add(scenes, "grazing floors", [](Builder& b) {
        for (int k = 0; k < 4; ++k) {
            const float tilt = 1e-4f * float(k);
            b.grid(9, [&](int i, int j) {
                const float x = float(i - 4) * 0.7f, z = float(j - 4) * 0.7f;
                return vec3(x, tilt * x + 1e-5f * float(whole(b.random, 0, 3)), z);
            });
        }
        b.box({-0.2f, 0, -0.2f}, {0.2f, 0.05f, 0.2f});
        b.light(point_light({2.5, 1e-3, 0.3}));
        b.light(directional_light({-1, -1e-4, 0.2}));
        b.light(directional_light({-1, -1e-7, 0.2}));
        b.eye({0.5, 0.4, 3.5});
    });
    add(scenes, "degenerate triangles", [](Builder& b) {
        b.floor(-1);
        for (int k = 0; k < 60; ++k) {
            const vec3 p = random_point(b.random), q = random_point(b.random);
            b.triangle(p, q, p);
            b.triangle(p, p, p);
            b.triangle(p, q, 0.5f * (p + q));
        }
        b.box({-0.3f, 0, -0.3f}, {0.3f, 0, 0.3f}); // flat
        b.some_lights();
        b.eye({1, 2, 3});
    });
    add(scenes, "layers a hair apart", [](Builder& b) {
        for (int k = 0; k < 60; ++k) {
            const float y = float(whole(b.random, -8, 8)) * 0x1p-19f;
            const auto p = [&] {
                return vec3(uniform(b.random, -2, 2), y, uniform(b.random, -2, 2));
            };
            b.triangle(p(), p(), p());
        }
        b.some_lights();
        b.eye({1, 2, 3});
    });
}

void add_wide(Scenes& scenes)
{
    add(scenes, "triangles all around the lights", [](Builder& b) {
        for (int k = 0; k < 80; ++k)
            b.triangle(
                random_point(b.random, 2), random_point(b.random, 2), random_point(b.random, 2));
        b.light(point_light({0, 0, 0}));
        b.light(point_light(dvec3(random_point(b.random))));
        b.light(spot_light({0, 0, 0}, dvec3(random_point(b.random)), 1.2));
        b.light(directional_light(dvec3(random_point(b.random))));
        b.eye({0, 0, 5});
    });
    add(scenes, "many small triangles", [](Builder& b) {
        b.floor(-1);
        for (int k = 0; k < 800; ++k) {
            const vec3 p = random_point(b.random);
            const auto near_p = [&] { return p + random_point(b.random, 0.08f); };
            b.triangle(near_p(), near_p(), near_p());
        }
        b.some_lights();
        b.eye({1, 2, 3});
    });
    add(scenes, "large triangles seen from near", [](Builder& b) {
        const auto floor = [](float x, float z) { return vec3(x, 0.31f * x - 0.17f * z, z); };
        b.quad(floor(-900, -900), floor(900, -900), floor(900, 900), floor(-900, 900));
        b.quad(floor(-900, 900), floor(-900, -900), floor(900, -900), floor(900, 900));
        b.light(point_light({0.1, 0.6, 0.2}));
        b.light(directional_light({0.3, -1, 0.4}));
        b.eye({0.3, 0.7, 0.2}, {0, 0, 0});
    });
    add(scenes, "huge and tiny together", [](Builder& b) {
        b.triangle({-3e11f, -2, -3e11f}, {3e11f, -2, -3e11f}, {0, -2, 3e11f});
        b.triangle({-3e5f, -1e6f, 1e5f}, {3e5f, 3e5f, 3e5f}, {0, 3e5f, -3e5f});
        for (int k = 0; k < 150; ++k) {
            const float size = std::pow(10.0f, uniform(b.random, -6, 1));
            const vec3 p = random_point(b.random);
            b.triangle(p + random_point(b.random, size), p + random_point(b.random, size),
                p + random_point(b.random, size));
        }
        b.some_lights();
        b.eye({0, 1, 4});
    });
    for (const float scale : {1e-20f, 1e-3f, 1e3f, 1e6f, 1e20f}) {
        scenes.push_back({"a box on a floor at scale " + std::to_string(int(std::log10(scale))),
            [scale](ShadowWorld& made, std::mt19937& random) {
                Builder b{made, random};
                box_on_floor(b);
                transform(made, scale, vec3(0));
            }});
    }
    scenes.push_back({"far from the origin", [](ShadowWorld& made, std::mt19937& random) {
                          Builder b{made, random};
                          box_on_floor(b);
                          transform(made, 1, {4e4f, -2e4f, 7e3f});
                      }});
}

} // namespace

const std::vector<ShadowScene>& shadow_scenes()
{
    static const Scenes scenes = [] {
        Scenes made;
        add_everyday(made);
        add_exact(made);
        add_thin(made);
        add_wide(made);
        add_rounding(made);
        return made;
    }();
    return scenes;
}

std::string shadow_test_name(const ShadowScene& scene)
{
    std::string name = scene.name;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

ShadowWorld make_shadow_world(const ShadowScene& scene, unsigned seed)
{
    std::mt19937 random(seed);
    ShadowWorld made;
    made.view.width = made.view.height = kShadowSize;
    scene.fill(made, random);
    made.world.finish();
    made.world.scene->lights = made.world.world.lights;
    made.world.world.camera = made.view.camera;
    return made;
}

ShadowPoints shadow_points(const ShadowWorld& made, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    const World& world = made.world.world;
    ShadowPoints result;
    for (std::size_t k = 0; k < count; ++k) {
        const auto triangle = std::uint32_t(random() % world.scene->index.size());
        const glm::uvec3 index = world.scene->index[triangle];
        const vec3 a = world.position[index.x], b = world.position[index.y],
                   c = world.position[index.z];
        const vec3 light(world.lights[random() % world.lights.size()].position);
        float u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        vec3 p = a + u * (b - a) + v * (c - a);
        bool on = true;
        switch (random() % 12) {
        case 0:
            p = a;
            break;
        case 1:
            p = 0.5f * (a + b);
            break;
        case 2:
            p = a + u * (b - a);
            break;
        case 3:
            p += random_point(random, 1e-5f * made.scale), on = false;
            break;
        case 4:
            p = light + uniform(random, 0, 1) * (p - light), on = false;
            break;
        case 5:
            p = light + 2.0f * (p - light), on = false;
            break;
        case 6:
            p += random_point(random, made.scale), on = false;
            break;
        case 7:
            if (k % 16 == 0) p = light, on = false;
            if (k % 16 == 1) p = vec3(NAN, 0, 0), on = false;
            if (k % 16 == 2) p = vec3(0, 1e30f, 0), on = false;
            break;
        default:
            break;
        }
        result.point.push_back(p);
        result.receiver.push_back(on && random() % 4 ? triangle : kNoItem);
    }
    return result;
}

} // namespace firsthit::test
