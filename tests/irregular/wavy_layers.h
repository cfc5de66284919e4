// wavy_layers.h - layers of small triangles, one behind the other, for shadows by a sample grid.
#pragma once

#include "instruction_sets.h"
#include "shadow/exact/planned_shadows.h"
#include "shadow/shadow_builder.h"

#include <gtest/gtest.h>

#include <numeric>

namespace firsthit::test {

/// Wavy sheets of 2 n n triangles across the z axis, one behind the other.
struct Layers {
    TestWorld world;

    Layers(int n, int layers, const glm::vec3& middle, float size)
    {
        std::mt19937 random{5};
        ShadowWorld made;
        Builder build{made, random};
        for (int layer = 0; layer < layers; ++layer) {
            build.grid(n, [&](int i, int j) {
                const float x = 2 * float(i) / float(n) - 1, y = 2 * float(j) / float(n) - 1;
                const float wave = 0.1f * std::sin(8 * x + float(layer)) * std::cos(7 * y);
                return middle + size * glm::vec3(x, y, 0.15f * float(layer) + wave);
            });
        }
        world = std::move(made.world);
        world.world.scene = world.scene;
    }

    /// Points at corners, on edges and inside of triangles. Every fifth point has no receiver.
    ShadowPoints points(int count) const
    {
        std::mt19937 random{7};
        ShadowPoints asked;
        const auto& index = world.scene->index;
        const auto& p = world.world.position;
        for (int k = 0; k < count; ++k) {
            const auto t = std::uint32_t(whole(random, 0, int(index.size()) - 1));
            const float u = k % 3 ? uniform(random, 0, 1) : 0.5f;
            const float v = k % 4 ? (1 - u) * uniform(random, 0, 1) : 0;
            const glm::uvec3 c = index[t];
            asked.point.push_back((1 - u - v) * p[c.x] + u * p[c.y] + v * p[c.z]);
            asked.receiver.push_back(k % 5 ? t : kNoItem);
        }
        return asked;
    }
};

/// Checks that the grid and the cells find the shadows of the plain loop, on every instruction set.
inline void expect_plain_shadows(const World& world, const Light& light, const ShadowPoints& asked)
{
    const PencilSpace space = light_space(light, glm::dvec3(0));
    const auto expected = plain_shadows(world, space, asked);
    const auto dark = std::size_t(std::accumulate(expected.begin(), expected.end(), 0));
    EXPECT_GT(dark, asked.point.size() / 20) << "nothing to find";
    EXPECT_LT(dark, asked.point.size() * 19 / 20) << "nothing to find";
    for_instruction_sets([&] {
        EXPECT_EQ(shadows(world, space, asked, ShadowPlan::grid), expected);
        EXPECT_EQ(shadows(world, space, asked, ShadowPlan::cells), expected);
    });
}

} // namespace firsthit::test
