// pose_allocation_test.cpp - posing allocates nothing once sizes have settled.
#include "scene/animate/pose.h"

#include "allocations.h"
#include "readers/aff/aff_text.h"
#include "scene/model/borrow.h"

#include <firsthit/normals.h>

#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(PoseAllocation, HappensOnlyInTheFirstPose)
{
    std::string text =
        "la lamp 0 0 0 v from 0 0 9 at 0 0 8 up 0 1 0 angle 90 hither 1 resolution 1 1 ";
    for (const char* name : {"lamp", "camera", "n"})
        text += std::string("k ") + name +
                "{ transl 4 0 0 0 0 0 0 0  1 1 0 0 0 0 0  2 2 0 0 0 0 0  3 3 0 0 0 0 0 "
                "rot 4 0 0 0 1 0 0 0 0  1 0 0 1 20 0 0 0  2 0 0 1 40 0 0 0  3 0 0 1 0 0 0 0 }";
    for (int k = 0; k < 100; ++k)
        text += "x n{ s 0 0 0 1 tpa 1 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 }";
    const Scene scene = scene_of(text);
    for (const int threads : {1, 2}) {
        Tasks tasks(threads);
        World world;
        pose(borrow(scene), 0, world, tasks);
        pose(borrow(scene), 1, world, tasks);
        const std::size_t before = allocations();
        for (int frame = 0; frame < 10; ++frame) pose(borrow(scene), 0.1 * frame, world, tasks);
        EXPECT_EQ(allocations(), before) << threads << " threads";
    }
}

TEST(PoseAllocation, NormalsAllocateOnlyTheFirstTime)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    update_normals(world);
    const std::size_t before = allocations();
    for (int frame = 0; frame < 3; ++frame) {
        world.position[0].x += 0.01f;
        update_normals(world);
    }
    EXPECT_EQ(allocations(), before);
}

} // namespace
} // namespace firsthit
