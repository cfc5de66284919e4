// shade_memory_test.cpp - shading allocates nothing.
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<int> allocations{0};
} // namespace

// Not inlined: g++ would see malloc and free inside, miss their partners, and warn.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace firsthit {
namespace {

TEST(ShadeMemory, IsNotAllocated)
{
    TileScene tile(32);
    Texture texture;
    texture.levels.push_back({2, 1, {0xFFFFFFu, 0x7F7F7Fu}});
    tile.scene.textures.push_back(texture);
    tile.add_material().texture = 0;
    tile.add_square({-3, -3, -10}, {6, 0, 0}, {0, 6, -3});
    tile.add_light({1, 2, 3});
    tile.cast();
    ShadeMemory memory;
    const int before = allocations;
    shade_tile(tile.hits, tile.world, memory.targets);
    EXPECT_EQ(allocations, before);
    EXPECT_GT(allocations, 0) << "nothing was counted";
}

} // namespace
} // namespace firsthit
