// point_shadows.cpp - which points of any set are in shadow?
#include "shadow/point_shadows.h"

#include "rays/brute_shadows.h"

namespace firsthit {

void test_points(const World& world, const LightSpace& space, std::span<const glm::vec3> points,
    std::span<const std::uint32_t> receivers, PointShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed)
{
    const auto move = [&](std::span<const glm::vec3> from, std::vector<glm::vec3>& to) {
        to.resize(from.size());
        tasks.for_ranges(from.size(), 16384, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) to[k] = to_light(space, from[k]);
        });
    };
    move(world.position, memory.corner);
    move(points, memory.point);
    brute_shadows(
        space, {memory.corner, world.scene->index}, memory.point, receivers, shadowed, tasks);
}

} // namespace firsthit
