// accessor_layout.h - where the components of an accessor's elements lie.
#pragma once

#include "readers/gltf/data/accessor.h"

#include <array>
#include <cstddef>

namespace firsthit::gltf {

struct ElementLayout {
    int components = 0;
    std::size_t size = 0;                 // bytes of an element, columns of matrices padded to 4
    std::array<std::size_t, 16> offset{}; // of each component
    bool packed = false;                  // the components follow one another
};

ElementLayout element_layout(ComponentType component, ElementType type);

/// Bytes from `offset` that `count` elements take; count is at most 2^28, stride at most 2^20.
inline std::size_t bytes_needed(std::size_t count, std::size_t stride, std::size_t size)
{
    return count == 0 ? 0 : (count - 1) * stride + size;
}

} // namespace firsthit::gltf
