// check_occlusion.h - checks the arguments of Occlusion.
#pragma once

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// points  number of points
/// throws  ArgumentError: see Occlusion
void check_occlusion(const World& world, std::size_t points, std::span<const Light> lights,
    std::span<const std::uint32_t> receivers);

} // namespace firsthit
