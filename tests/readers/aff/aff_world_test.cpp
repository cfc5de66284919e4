// aff_world_test.cpp - camera, lights, surroundings and materials of AFF.
#include "readers/aff/aff_text.h"
#include "scene/model/borrow.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

Phong material_of(const std::string& text)
{
    const Scene scene = scene_of(text + "\n" + kTriangle);
    EXPECT_EQ(scene.materials.size(), 1u);
    return std::get<Phong>(scene.materials[scene.instances[0].material].model);
}

TEST(AffWorld, ReadsTheCamera)
{
    const Scene scene = scene_of("v from 1 2 3 at 1 2 1 up 0 1 0.5 angle 90 hither 1e-9 "
                                 "resolution 640 480");
    ASSERT_EQ(scene.cameras.size(), 1u);
    const Camera& camera = scene.cameras[0].camera;
    EXPECT_EQ(camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(camera.direction, glm::dvec3(0, 0, -2));
    EXPECT_EQ(camera.up, glm::dvec3(0, 1, 0.5));
    EXPECT_DOUBLE_EQ(camera.fov_y_rad, 1.5707963267948966);
    EXPECT_EQ(scene.cameras[0].node, -1);
}

TEST(AffWorld, HasNoCameraWhereNoneIsGiven)
{
    EXPECT_TRUE(scene_of(kTriangle).cameras.empty());
}

TEST(AffWorld, FollowsTheTrackNamedCamera)
{
    const Scene scene = scene_of("k camera { transl 4 0 1 2 3 0 0 0 0 1 2 3 0 0 0 "
                                 "1 5 2 3 0 0 0 1 5 2 3 0 0 0 }");
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].node, 1);
    EXPECT_EQ(scene.clips.at(0).channels.at(0).node, 1u);
    // What the track lacks stays.
    const Scene both = scene_of("v from 1 2 3 at 1 2 1 up 0 1 0.5 angle 90 hither 1 resolution 4 4 "
                                "k camera { transl 4 0 7 8 9 0 0 0 0 7 8 9 0 0 0 "
                                "1 7 8 9 0 0 0 1 7 8 9 0 0 0 }");
    World world;
    pose(borrow(both), 0, world);
    EXPECT_EQ(world.camera.eye, glm::dvec3(7, 8, 9));
    EXPECT_EQ(world.camera.direction, glm::dvec3(0, 0, -2));
    EXPECT_EQ(world.camera.up, glm::dvec3(0, 1, 0.5));
}

TEST(AffWorld, LetsAWrongViewBeWhereATrackTurnsTheCamera)
{
    const std::string view = "v from 0 0 0 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 4 4 ";
    EXPECT_THROW(scene_of(view), SceneError);
    std::string track = "k camera { rot 4";
    for (int k = 0; k < 4; ++k) track += " " + std::to_string(k) + " 0 1 0 45 0 0 0";
    EXPECT_NO_THROW(scene_of(view + track + "}"));
}

TEST(AffWorld, ReadsLightsWithAndWithoutColour)
{
    const Scene scene = scene_of("l 1 2 3 l 4 5 6 .1 .2 3\nla lamp 7 8 9 la lamp 1 1 1 1 0 0");
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1));
    EXPECT_EQ(scene.lights[1].color, glm::vec3(0.1f, 0.2f, 3.0f));
    EXPECT_EQ(scene.lights[2].color, glm::vec3(1));
    EXPECT_EQ(scene.lights[3].color, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.lights[2].node, -1) << "no such track";
}

TEST(AffWorld, BindsLightsToTracksThatComeLater)
{
    const Scene scene = scene_of("la lamp 7 8 9 k other { } k lamp { transl 4 0 1 2 3 0 0 0 "
                                 "0 1 2 3 0 0 0 1 5 2 3 0 0 0 1 5 2 3 0 0 0 }");
    EXPECT_EQ(scene.nodes.at(std::size_t(scene.lights[0].node)).name, "lamp");
    const Scene still = scene_of("la lamp 7 8 9 k lamp { }");
    EXPECT_EQ(still.lights[0].node, -1) << "the track does not move it";
    EXPECT_EQ(still.lights[0].position, glm::dvec3(7, 8, 9));
}

TEST(AffWorld, ReadsBackgroundAmbientAndTimes)
{
    const Scene scene = scene_of("b .1 .2 .3 am .4 .5 .6 a 1.5 9 26");
    EXPECT_EQ(scene.background, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.ambient, glm::vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(scene.begin_s(), 1.5);
    EXPECT_EQ(scene.end_s(), 9);
    EXPECT_EQ(scene.frames(), 26);
}

TEST(AffWorld, IsBlackFullyAmbientAndStillByDefault)
{
    const Scene scene = scene_of(kTriangle);
    EXPECT_EQ(scene.background, glm::vec3(0));
    EXPECT_EQ(scene.ambient, glm::vec3(1));
    EXPECT_EQ(scene.begin_s(), scene.end_s());
}

TEST(AffWorld, ReadsSimpleMaterials)
{
    const Phong m = material_of("f 1 .5 .25 .5 .3 20 .1 1.5");
    EXPECT_EQ(m.ambient, glm::vec3(0));
    EXPECT_EQ(m.diffuse, glm::vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(m.specular, glm::vec3(0.3f));
    EXPECT_EQ(m.shininess, 20);
    EXPECT_EQ(m.transmittance, 0.1f);
    EXPECT_EQ(m.ior, 1.5f);
    EXPECT_EQ(m.texture, -1);
}

TEST(AffWorld, ReadsFullMaterials)
{
    const Phong m = material_of("fm .1 .2 .3 .4 .5 .6 .7 .8 .9 10 .5 1.3");
    EXPECT_EQ(m.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.diffuse, glm::vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(m.specular, glm::vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(m.shininess, 10);
    EXPECT_EQ(scene_of("fm .1 .2 .3 .4 .5 .6 .7 .8 .9 10 .5 1.3\n" + kTriangle).materials[0].name,
        "main.aff:1");
}

TEST(AffWorld, KeepsEqualMaterialsOnce)
{
    const std::string red = "f 1 0 0 1 0 1 0 1 ", blue = "f 0 0 1 1 0 1 0 1 ";
    const Scene scene =
        scene_of(red + kTriangle + blue + kTriangle + red + kTriangle + blue + red + kTriangle);
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.instances.size(), 3u) << "the last two triangles share node and material";
}

} // namespace
} // namespace firsthit
