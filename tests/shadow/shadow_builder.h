// shadow_builder.h - floors, boxes, balls and lights for shadow scenes.
#pragma once

#include "shadow/shadow_scenes.h"

#include "random_numbers.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace firsthit::test {

inline glm::vec3 random_point(std::mt19937& random, float half = 1)
{
    return {
        uniform(random, -half, half), uniform(random, -half, half), uniform(random, -half, half)};
}

inline glm::vec3 whole_point(std::mt19937& random, int half)
{
    return glm::vec3(
        whole(random, -half, half), whole(random, -half, half), whole(random, -half, half));
}

/// Builds a world in units of about 1 around the origin; `finish` scales and moves it.
struct Builder {
    ShadowWorld& made;
    std::mt19937& random;

    void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        made.world.add(a, b, c);
    }
    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
    {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    /// n x n quads of vertices `point(i, j)`, i and j in [0, n], which neighbouring quads share.
    template <class F>
    void grid(int n, const F& point)
    {
        const auto first = std::uint32_t(made.world.world.position.size());
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) made.world.world.position.push_back(point(i, j));
        const auto vertex = [&](int i, int j) { return first + std::uint32_t(j * (n + 1) + i); };
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                made.world.scene->index.push_back(
                    {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
                made.world.scene->index.push_back(
                    {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
            }
        }
    }
    void floor(float y = 0, float half = 3, int n = 6)
    {
        grid(n, [&](int i, int j) {
            return glm::vec3(
                half * (2 * float(i) / float(n) - 1), y, half * (2 * float(j) / float(n) - 1));
        });
    }
    void box(const glm::vec3& low, const glm::vec3& high)
    {
        const auto at = [&](int k) {
            return glm::vec3(
                k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
        };
        for (const auto& f :
            {std::array{0, 1, 3, 2}, std::array{4, 6, 7, 5}, std::array{0, 4, 5, 1},
                std::array{2, 3, 7, 6}, std::array{0, 2, 6, 4}, std::array{1, 5, 7, 3}})
            quad(at(f[0]), at(f[1]), at(f[2]), at(f[3]));
    }
    void sphere(const glm::vec3& middle, float radius, int n = 24)
    {
        const double step = std::numbers::pi / n;
        grid(n, [&](int i, int j) {
            const double a = 2 * step * (i % n), b = step * j;
            const double ring = j % n == 0 ? 0 : std::sin(b);
            return middle + radius * glm::vec3(glm::dvec3(
                                         ring * std::cos(a), std::cos(b), ring * std::sin(a)));
        });
    }
    void light(const Light& l) { made.world.world.lights.push_back(l); }
    void eye(const glm::dvec3& eye, const glm::dvec3& at = glm::dvec3(0))
    {
        made.view.camera.eye = eye;
        made.view.camera.direction = at - eye;
    }
    void some_lights()
    {
        light(point_light(glm::dvec3(random_point(random, 2)) + glm::dvec3(0, 3, 0)));
        light(directional_light(glm::dvec3(random_point(random)) - glm::dvec3(0, 1.5, 0)));
        light(spot_light({0.5, 3, 0.25}, {-0.1, -1, 0.1}, uniform(random, 0.2f, 1.2f)));
    }
};

/// Scales a finished world by `factor`, then moves it.
inline void transform(ShadowWorld& made, float factor, const glm::vec3& offset)
{
    made.scale = factor;
    for (glm::vec3& p : made.world.world.position) p = p * factor + offset;
    for (Light& l : made.world.world.lights)
        l.position = l.position * double(factor) + glm::dvec3(offset);
    made.view.camera.eye = made.view.camera.eye * double(factor) + glm::dvec3(offset);
    made.view.camera.direction *= double(factor);
}

using Scenes = std::vector<ShadowScene>;

/// build(Builder&) fills an empty world.
template <class F>
void add(Scenes& scenes, std::string name, F build)
{
    scenes.push_back({std::move(name), [build](ShadowWorld& made, std::mt19937& random) {
                          Builder b{made, random};
                          build(b);
                      }});
}

/// Scenes whose shadows depend on the last bits (rounding_scenes.cpp).
void add_rounding(Scenes& scenes);

} // namespace firsthit::test
