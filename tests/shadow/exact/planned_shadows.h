// planned_shadows.h - exact shadows of points by a plan that the test chooses, and by the plain loop.
#pragma once

#include "rays/brute_shadows.h"
#include "shadow/exact/point_shadows.h"
#include "shadow/shadow_scenes.h"

#include <cstdint>
#include <vector>

namespace firsthit::test {

/// Which of the points are in shadow.
inline std::vector<std::uint8_t> shadows(const World& world, const PencilSpace& space,
    const ShadowPoints& asked, ShadowPlan plan, int threads = 1)
{
    Tasks tasks(threads);
    ShadowMemory memory;
    memory.plan = plan;
    PointSet set;
    make_point_set(asked.point, asked.receiver, true, set, tasks);
    std::vector<std::uint8_t> shadowed(asked.point.size());
    test_points(world, space, set, memory, tasks, shadowed);
    return shadowed;
}

/// The same by every triangle's shadow, point by point.
inline std::vector<std::uint8_t> plain_shadows(
    const World& world, const PencilSpace& space, const ShadowPoints& asked)
{
    const std::vector<glm::vec3> corner = all_to_light(space, world.position);
    const LightTriangles triangles{corner, world.scene->index};
    std::vector<std::uint8_t> shadowed;
    Effort effort;
    for (std::size_t k = 0; k < asked.point.size(); ++k) {
        glm::vec3 d = to_light(space, asked.point[k]);
        const std::uint32_t receiver = asked.receiver[k];
        if (receiver != kNoItem) {
            const Corners c = triangles[receiver];
            d = lifted(space, d, receiver_of(c, light_side(space, c, effort)));
        }
        shadowed.push_back(is_shadowed_brute(space, triangles, d, receiver, effort));
    }
    return shadowed;
}

} // namespace firsthit::test
