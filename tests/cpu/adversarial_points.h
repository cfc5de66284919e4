// adversarial_points.h - points in pixels, and grids of them, for adversarial scenes.
#pragma once

#include "cpu/adversarial_scenes.h"

#include "random_numbers.h"

#include <cstdint>
#include <random>

namespace firsthit::test {

/// The point that projects to (x, y) pixels from the picture's centre at depth z.
inline glm::vec3 at(float x, float y, float z)
{
    return {x * z / kSize, y * z / kSize, z};
}

inline glm::vec3 random_at(std::mt19937& random, float half = 30, float near = 1, float far = 9)
{
    return at(
        uniform(random, -half, half), uniform(random, -half, half), uniform(random, near, far));
}

/// A grid of quads, split at random, over points made by `point(i, j)`, i and j in [0, n].
template <class F>
void add_grid(TestWorld& world, std::mt19937& random, int n, const F& point)
{
    const auto first = std::uint32_t(world.world.position.size());
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) world.world.position.push_back(point(i, j));
    const auto vertex = [&](int i, int j) { return first + std::uint32_t(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                                d = vertex(i, j + 1);
            if (random() & 1) {
                world.scene->index.push_back({a, b, c});
                world.scene->index.push_back({a, c, d});
            } else {
                world.scene->index.push_back({a, b, d});
                world.scene->index.push_back({b, c, d});
            }
        }
    }
}

} // namespace firsthit::test
