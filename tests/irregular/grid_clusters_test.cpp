// grid_clusters_test.cpp - shadows by clusters of eight triangles on a sample grid are exact: for
// any order of the triangles, for crowded samples, and for triangles with a corner behind the light.
#include "irregular/wavy_layers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit::test {
namespace {

/// Shuffles the order of runs of up to `longest` consecutive triangles. Receivers are renumbered, so
/// that each point stays on its triangle.
void shuffle_runs(int longest, Layers& layers, ShadowPoints& asked)
{
    std::mt19937 random{3};
    auto& index = layers.world.scene->index;
    std::vector<std::vector<std::uint32_t>> runs;
    for (std::uint32_t t = 0; t < index.size();) {
        runs.emplace_back();
        const int length = whole(random, 1, longest);
        for (int k = 0; k < length && t < index.size(); ++k) runs.back().push_back(t++);
    }
    std::shuffle(runs.begin(), runs.end(), random);
    const auto before = index;
    std::vector<std::uint32_t> now(before.size());
    std::uint32_t next = 0;
    for (const auto& run : runs)
        for (const std::uint32_t t : run) {
            now[t] = next;
            index[next++] = before[t];
        }
    for (std::uint32_t& receiver : asked.receiver)
        if (receiver != kNoItem) receiver = now[receiver];
}

TEST(GridClusters, FindTheShadowsOfTrianglesInAnyOrder)
{
    for (const int longest : {1, 5, 40}) {
        Layers layers(24, 2, glm::vec3(0), 1);
        ShadowPoints asked = layers.points(1000);
        shuffle_runs(longest, layers, asked);
        expect_plain_shadows(layers.world.world, point_light({0.3, 0.2, -3}), asked);
        expect_plain_shadows(layers.world.world, directional_light({0.1, -0.2, 1}), asked);
    }
}

TEST(GridClusters, MayBeIncompleteAtTheEndOfAMesh)
{
    for (std::size_t left_out = 1; left_out <= 8; ++left_out) {
        Layers layers(13, 2, glm::vec3(0), 1);
        auto& index = layers.world.scene->index;
        index.resize(index.size() - left_out);
        expect_plain_shadows(layers.world.world, point_light({0.3, 0.2, -3}), layers.points(400));
    }
}

TEST(GridClusters, MayOverlapFewSamplesOrManyInOneMesh)
{
    // Half of the points project to about four triangles, and lie at all distances from the light.
    const Layers layers(24, 2, glm::vec3(0), 1);
    ShadowPoints asked = layers.points(800);
    std::mt19937 random{4};
    for (int k = 0; k < 800; ++k) {
        asked.point.push_back({uniform(random, 0.3f, 0.4f), uniform(random, -0.1f, 0.0f),
            uniform(random, -0.2f, 0.4f)});
        asked.receiver.push_back(kNoItem);
    }
    expect_plain_shadows(layers.world.world, point_light({0.3, 0.2, -3}), asked);
    expect_plain_shadows(layers.world.world, directional_light({0.1, -0.2, 1}), asked);
}

TEST(GridClusters, MayHaveTrianglesWithCornersBehindTheLight)
{
    const Layers layers(24, 1, glm::vec3(0), 1);
    const ShadowPoints asked = layers.points(1000);
    for (const glm::dvec3 at : {glm::dvec3(0.1, 0.2, 0.08), glm::dvec3(0.7, -0.4, -0.06)})
        expect_plain_shadows(layers.world.world, point_light(at), asked);
}

} // namespace
} // namespace firsthit::test
