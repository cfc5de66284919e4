// ground_test.cpp - a floor that is added to a scene.
#include <firsthit/environment.h>
#include <firsthit/error.h>
#include <firsthit/ground.h>
#include <firsthit/world.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>

namespace firsthit {
namespace {

Scene triangle_scene()
{
    Scene scene = scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    scene.uv.assign(scene.vertices, glm::vec2(0.5f));
    scene.color.assign(scene.vertices, glm::vec4(0.5f));
    return scene;
}

TEST(Ground, IsTheLastInstanceAndHasTheLastTriangles)
{
    Scene scene = triangle_scene();
    const std::size_t vertices = scene.vertices, materials = scene.materials.size();
    const std::uint32_t material = add_ground(scene,
        {.middle = {1, -2, 3}, .up = {0, 5, 0}, .half_side = 4, .color = {0.1f, 0.2f, 0.3f}});
    EXPECT_EQ(material, materials);
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[1].name, "ground");
    EXPECT_EQ(scene.instances[1].first_triangle, 1u);
    EXPECT_EQ(scene.triangle_count(), 3u);
    EXPECT_EQ(scene.owner, (std::vector<std::uint32_t>{0, 1, 1}));
    EXPECT_EQ(scene.vertices, vertices + 4);
    EXPECT_EQ(scene.uv.size(), scene.vertices);
    EXPECT_EQ(scene.color.back(), glm::vec4(1));
    EXPECT_TRUE(scene.tangent.empty());
    EXPECT_EQ(
        std::get<Phong>(scene.materials[material].model).diffuse, glm::vec3(0.1f, 0.2f, 0.3f));

    World world;
    pose(std::move(scene), 0, world);
    glm::vec3 low(9), high(-9);
    for (std::size_t v = vertices; v < vertices + 4; ++v) {
        EXPECT_EQ(world.normal[v], glm::vec3(0, 1, 0));
        low = glm::min(low, world.position[v]);
        high = glm::max(high, world.position[v]);
    }
    EXPECT_EQ(low, glm::vec3(-3, -2, -1));
    EXPECT_EQ(high, glm::vec3(5, -2, 7));
    for (std::size_t t = 1; t < 3; ++t) {
        const glm::uvec3& corner = world.scene->index[t];
        const glm::vec3 a = world.position[corner.x];
        EXPECT_GT(glm::cross(world.position[corner.y] - a, world.position[corner.z] - a).y, 0)
            << "counter-clockwise";
    }
}

TEST(Ground, LiesAcrossEveryDirection)
{
    for (const glm::dvec3& up : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 2, 3)}) {
        Scene scene = triangle_scene();
        add_ground(scene, {.middle = {1, 1, 1}, .up = up, .half_side = 2});
        for (std::size_t v = scene.vertices - 4; v < scene.vertices; ++v)
            EXPECT_NEAR(glm::dot(glm::dvec3(scene.position[v]) - glm::dvec3(1), up), 0, 1e-5);
    }
}

TEST(Ground, UnderTheLightOfAnEnvironmentReflectsIt)
{
    Scene scene = triangle_scene();
    scene.environment.map = constant_environment(glm::vec3(1));
    const std::uint32_t material = add_ground(scene, {.color = glm::vec3(0.25f)});
    const auto& model = std::get<MetallicRoughness>(scene.materials[material].model);
    EXPECT_EQ(model.base_color, glm::vec3(0.25f));
    EXPECT_EQ(model.metallic, 0);
}

TEST(Ground, WithoutASizeADirectionOrAColorIsRefused)
{
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const Ground& wrong : {Ground{.up = glm::dvec3(0)}, Ground{.half_side = 0},
             Ground{.half_side = -1}, Ground{.middle = {kNaN, 0, 0}}, Ground{.half_side = kNaN},
             Ground{.color = glm::vec3(-1)}, Ground{.up = {0, kNaN, 0}}}) {
        Scene scene = triangle_scene();
        EXPECT_THROW(add_ground(scene, wrong), ArgumentError);
        EXPECT_EQ(scene.instances.size(), 1u);
    }
}

} // namespace
} // namespace firsthit
