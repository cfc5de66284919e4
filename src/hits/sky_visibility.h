// sky_visibility.h - which directions of the sky the samples of one tile see.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firsthit {

/// A sky (firsthit/options/sky_options.h) in the form that shading needs, computed once for each frame.
struct SkyRays {
    std::vector<float> x, y, z; // (directions) unit vectors towards the sky
    float full = 1;             // the sum of their cosines for a surface that faces up
    glm::vec3 up{0, 1, 0};      // unit
    glm::vec3 color{0};
    glm::vec3 ground{0};
    float bounce = 0;

    std::size_t count() const { return x.size(); }
};

/// The directions that are open to the samples of a tile.
struct SkyVisibility {
    /// (blocks, directions) bit k of a word: the direction is open to sample k of the block.
    /// Undefined for samples without an item.
    const std::uint64_t* words = nullptr;
    const SkyRays* rays = nullptr; // null: there is no sky

    /// (directions) of one block.
    const std::uint64_t* of_block(std::size_t block) const { return words + block * rays->count(); }
};

} // namespace firsthit
