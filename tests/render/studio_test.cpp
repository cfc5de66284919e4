// studio_test.cpp - the lights of scenes that have none of their own.
#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit::test {
namespace {

TEST(Studio, KeepsWhiteSurfacesBelowOne)
{
    Scene scene;
    scene.materials = {{}};
    set_up_studio(scene);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_FALSE(has_own_lights(scene));
    const glm::vec3 to_key(glm::normalize(-scene.lights[0].direction));
    const Sky sky = studio_sky();
    for (const glm::dvec3& d : sky_directions(256, {0, 0.3, 1})) {
        const glm::vec3 n(d);
        const float light = scene.lights[0].color.x * std::max(0.0f, glm::dot(n, to_key)) +
                            sky.color.x * (0.5f + 0.5f * n.y) + sky.ground.x * (0.5f - 0.5f * n.y);
        EXPECT_LT(light, 0.99f);
    }
}

TEST(Studio, LightsOfAFileAreItsOwn)
{
    Scene scene;
    EXPECT_FALSE(has_own_lights(scene));
    scene.lights.push_back({.name = "default"});
    EXPECT_TRUE(has_own_lights(scene)) << "it does not hang on the camera";
    set_up_studio(scene, false);
    EXPECT_FALSE(has_own_lights(scene));
}

TEST(Studio, TakesAmbientLightAwayButNotWhatShines)
{
    Scene scene;
    scene.materials.resize(2);
    scene.materials[0].model = Phong{.ambient = glm::vec3(0.5f), .diffuse = glm::vec3(0.5f)};
    scene.materials[1].model = Phong{.ambient = glm::vec3(5.5f), .diffuse = glm::vec3(0.5f)};
    scene.background = {0.1f, 0, 0};
    set_up_studio(scene);
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).ambient, glm::vec3(0));
    EXPECT_EQ(std::get<Phong>(scene.materials[1].model).ambient, glm::vec3(5));
    EXPECT_EQ(scene.background, glm::vec3(0.1f, 0, 0));
}

} // namespace
} // namespace firsthit::test
