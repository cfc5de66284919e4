// skinned_arm.cpp - an arm of one mesh and two joints that bends, and what a camera sees of it.
#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>

#include <cstdio>
#include <memory>
#include <utility>

int main()
{
    firsthit::Mesh
        arm; // a strip of four squares, 4 long: each row of vertices follows one or both joints
    arm.shape.skin.influences = 2;
    for (int row = 0; row <= 4; ++row)
        for (const float x : {-0.5f, 0.5f}) {
            const float upper = row < 2    ? 1.0f
                                : row == 2 ? 0.5f
                                           : 0.0f; // how much follows the shoulder
            arm.position.push_back({x, float(row), 0});
            arm.shape.skin.joint.insert(arm.shape.skin.joint.end(), {0, 1});
            arm.shape.skin.weight.insert(arm.shape.skin.weight.end(), {upper, 1 - upper});
        }
    for (unsigned a = 0; a < 8; a += 2) { // without normals the squares are flat, in every pose
        arm.index.push_back({a, a + 1, a + 3});
        arm.index.push_back({a, a + 3, a + 2});
    }
    firsthit::SceneBuilder builder("arm");
    const auto shoulder =
        builder.add_node({.name = "shoulder", .transform = firsthit::NodeTransform{}});
    const auto elbow = builder.add_node({.name = "elbow",
        .parent = std::int32_t(shoulder),
        .transform = firsthit::NodeTransform{.translation = {0, 2, 0}}});
    glm::dmat4 elbow_from_arm(1); // where the elbow is when the arm is straight
    elbow_from_arm[3] = {0, -2, 0, 1};
    builder.add_skin({"bones", {shoulder, elbow}, {glm::dmat4(1), elbow_from_arm}});
    builder.add_instance(builder.add_mesh(std::move(arm)), shoulder, builder.add_material({}), 0);
    firsthit::Channel bend; // a quarter turn to the right in a second
    bend.node = elbow;
    bend.path = firsthit::Channel::Path::rotation;
    bend.time_s = {0, 1};
    bend.value = {0, 0, 0, 1, 0, 0, -0.7071067811865476, 0.7071067811865476};
    builder.add_clip({.name = "bend", .end_s = 1, .channels = {bend}});
    const auto scene = std::make_shared<const firsthit::Scene>(builder.build());

    firsthit::World world;
    for (const double time_s : {0.0, 0.5, 1.0}) {
        firsthit::pose(scene, time_s, world);
        const glm::vec3& hand = world.position.back(); // the last corner of the last triangle
        std::printf("%.1f s: the hand is at %5.2f %5.2f\n", time_s, hand.x, hand.y);
    }
    return glm::distance(world.position.back(), glm::vec3(2, 2.5f, 0)) < 1e-6f ? 0 : 1;
}
