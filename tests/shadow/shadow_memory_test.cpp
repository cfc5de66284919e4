// shadow_memory_test.cpp - shadow maps allocate nothing once their sizes have settled.
#include "allocations.h"
#include "shadow/map/map_scenes.h"

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

TEST(ShadowMaps, AllocateNothingOnceTheirSizesHaveSettled)
{
    TestWorld world = box_over_floor();
    world.world.lights = {point_light({1, -3, 5}), directional_light({0.1, 1, 0}),
        spot_light({0, -3, 5}, {0, 1, 0}, 0.5)};
    Tasks tasks(1);
    const HitPicture picture(world.world, straight_view(96, 80, 70), tasks);
    ShadowMaps maps;
    const Settings settings;
    static TileVisibility visibility;
    std::size_t before = 0;
    for (int frame = 0; frame < 6; ++frame) {
        if (frame == 2) before = allocations();
        world.world.position.back().x += 1e-3f;
        make_maps(world.world, picture, settings, tasks, maps);
        for (const auto& tile : picture.tiles)
            for (std::size_t light = 0; light < 3; ++light)
                sample_shadow_map(maps, world.world, tile->hits, light, visibility.value);
    }
    EXPECT_EQ(allocations(), before);
    EXPECT_EQ(maps.updates, 18u);
}

} // namespace
} // namespace firsthit::test
