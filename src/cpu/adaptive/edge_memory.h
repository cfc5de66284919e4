// edge_memory.h - what is remembered of the ray through the centre of each pixel, to look for edges.
#pragma once

#include "base/buffer.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace firsthit {

/// What the pixels of a block see.
struct BlockSight {
    static constexpr std::uint32_t kSeveral = 0xFFFFFFFF;

    float least_w = 0;              // the least 1/t; 0: a pixel sees nothing
    float most_w = 0;               // the greatest
    std::uint32_t owner = kSeveral; // the instance of which all see one side, with normals at most
                                    // 30 degrees from `normal`
    std::uint32_t item = kSeveral;  // the triangle that all see
    glm::vec3 normal{0};            // unit, in the world, towards the eye
};

/// What the pixels of a region see. Blocks are of 8x8 pixels, from the region's first one.
struct EdgeSight {
    /// (height, width) the triangle that is seen; undefined where nothing is
    Buffer<std::uint32_t> item;
    /// (height, width) the instance, times 2; kNoItem where nothing is seen. Bit 0: its material has
    /// textures.
    Buffer<std::uint32_t> kind;
    Buffer<std::uint32_t> lit; // (height, width) a number that says which lights arrive
    Buffer<float> w;           // (height, width) 1/t; 0 where nothing is seen
    Buffer<BlockSight> block;

    /// Sets the region's size.
    void resize(int width, int height);
};

/// Memory that is kept from frame to frame.
struct EdgeMemory {
    EdgeSight first, other;             // of the first layer, and of another one
    std::vector<std::uint8_t> textured; // (instances)

    /// Of one thread.
    struct Worker {
        Buffer<std::uint32_t> kind, lit;    // of a tile, in tile order
        Buffer<float> w;                    // the same
        std::vector<float> color;           // of some rows, as codes
        std::vector<std::uint32_t> numbers; // of the same rows: kinds and lights
        std::vector<float> bend;            // of a row
    };
    std::vector<Worker> worker; // (threads)
};

} // namespace firsthit
