// check_occlusion.h - refuses points, lights and receivers that cannot be tested.
#pragma once

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// throws  ArgumentError, as Occlusion's functions
void check_occlusion(const World& world, std::size_t points, std::span<const Light> lights,
    std::span<const std::uint32_t> receivers);

} // namespace firsthit
