// grid_layers_test.cpp - shadows by a sample grid are exact where it takes short cuts: triangles behind
// all samples, one wide face, and quantized coordinates that are finer than the coordinates' own
// roundings.
#include "irregular/wavy_layers.h"

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

int wide_face(const World& world, const Light& light)
{
    Tasks tasks(1);
    PencilMesh mesh;
    make_pencil_mesh(
        light_space(light, glm::dvec3(0)), world.position, world.scene->index, mesh, tasks);
    return mesh.wide_face;
}

TEST(GridLayers, ThatLieBehindAllSamplesShadowNothing)
{
    // All points are on the two layers nearest to the light, or on all.
    const Layers layers(24, 5, glm::vec3(0), 1);
    const World& world = layers.world.world;
    for (const bool near : {true, false}) {
        ShadowPoints all = layers.points(1500), asked;
        for (std::size_t k = 0; k < all.point.size(); ++k) {
            if (near && all.point[k].z > 0.2f) continue;
            asked.point.push_back(all.point[k]);
            asked.receiver.push_back(all.receiver[k]);
        }
        expect_plain_shadows(world, point_light({0.3, 0.2, -3}), asked);
        expect_plain_shadows(world, directional_light({0.1, -0.2, 1}), asked);
    }
}

TEST(GridLayers, ProjectToOneWideFaceAcrossTheCubesEdges)
{
    const Layers layers(20, 3, glm::vec3(0), 1);
    const World& world = layers.world.world;
    const Light light = point_light({-2, 1.8, -2.2});
    ASSERT_GE(wide_face(world, light), 0);
    expect_plain_shadows(world, light, layers.points(1000));
}

TEST(GridLayers, ShadowPointsOutsideOfTheWideFace)
{
    // Points are anywhere, also behind the light and beside all triangles.
    const Layers layers(20, 2, glm::vec3(0, 0, 1.5), 1);
    const World& world = layers.world.world;
    const Light light = point_light({0.4, 0, 0.9});
    ASSERT_EQ(wide_face(world, light), 4);
    std::mt19937 random{11};
    ShadowPoints asked;
    for (int k = 0; k < 1500; ++k) {
        const auto along = [&] { return uniform(random, -4, 4); };
        asked.point.push_back({along(), along(), along()});
        asked.receiver.push_back(kNoItem);
    }
    expect_plain_shadows(world, light, asked);
}

TEST(GridLayers, ThatAreSmallAndFarFromTheAxisAreDecidedInFullPrecision)
{
    // The quantized coordinates of samples and corners are off by up to a hundred, because the
    // roundings of the projection are far larger than a 65,536th of the samples' bounds.
    for (const float size : {1e-2f, 1e-3f, 1e-4f}) {
        const Layers layers(20, 3, glm::vec3(5, 4, 0), size);
        expect_plain_shadows(
            layers.world.world, point_light({0, 0, -2 - 3 * double(size)}), layers.points(800));
    }
}

} // namespace
} // namespace firsthit::test
