// holes.cpp - the samples that have no colour of their own, and how they are filled.
#include "cpu/holes.h"

#include "film/fill_holes.h"

#include <firsthit/scene.h>

#include <atomic>
#include <bit>

namespace firsthit {

void resize(HoleMemory& memory, int tile_size, std::size_t tiles)
{
    const auto blocks_x = std::size_t(tile_size / kBlock);
    memory.blocks = blocks_x * blocks_x;
    memory.sample.resize(tiles * memory.blocks);
}

std::uint64_t count_holes(std::span<const std::uint64_t> holes)
{
    std::uint64_t count = 0;
    for (const std::uint64_t word : holes)
        // Mostly there are no holes: this avoids popcount, which may be a function call.
        if (word != 0) count += std::uint64_t(std::popcount(word));
    return count;
}

std::uint64_t interpolate_holes(const HoleMemory& memory, Tasks& tasks, Film& film)
{
    constexpr std::size_t kRows = 32; // rows of a task
    const HolePicture picture{film.width, film.height, memory.pixel.span(), film.color.value};
    std::atomic<std::uint64_t> filled{0};
    tasks.for_ranges(std::size_t(film.height), kRows, [&](std::size_t first, std::size_t last) {
        filled += fill_holes(picture, int(first), int(last));
    });
    return filled;
}

} // namespace firsthit
