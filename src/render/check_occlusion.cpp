// check_occlusion.cpp - checks the arguments of Occlusion.
#include "render/check_occlusion.h"

#include "scene/model/check_light.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit {

void check_occlusion(const World& world, std::size_t points, std::span<const Light> lights,
    std::span<const std::uint32_t> receivers)
{
    if (!world.scene) throw ArgumentError("the world has no scene: pose it first");
    if (points >= kNoItem)
        throw ArgumentError(fmt::format("{} points are too many: at most {}", points, kNoItem - 1));
    for (std::size_t l = 0; l < lights.size(); ++l)
        if (const std::string fault = fault_of(lights[l]); !fault.empty())
            throw ArgumentError(fmt::format("light {}: {}", l, fault));
    if (receivers.empty()) return;
    if (receivers.size() != points)
        throw ArgumentError(fmt::format("{} receivers for {} points: one for each is accepted, or "
                                        "none at all",
            receivers.size(), points));
    const std::size_t triangles = world.scene->index.size();
    for (std::size_t k = 0; k < receivers.size(); ++k)
        if (receivers[k] != kNoItem && receivers[k] >= triangles)
            throw ArgumentError(fmt::format("receiver {} of point {} is no triangle: the scene has "
                                            "{}, numbered from 0",
                receivers[k], k, triangles));
}

} // namespace firsthit
