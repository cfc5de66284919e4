// shade_memory_test.cpp - shading allocates nothing.
#include "allocations.h"
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(ShadeMemory, IsNotAllocated)
{
    TileScene tile(32);
    tile.scene.textures.emplace_back("two", Picture{2, 1, {0xFFFFFFu, 0x7F7F7Fu}});
    tile.add_material().texture = 0;
    tile.add_square({-3, -3, -10}, {6, 0, 0}, {0, 6, -3});
    tile.add_light({1, 2, 3});
    tile.cast();
    ShadeMemory memory;
    const std::size_t before = allocations();
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(allocations(), before);
    EXPECT_GT(allocations(), 0u) << "nothing was counted";
}

} // namespace
} // namespace firsthit
