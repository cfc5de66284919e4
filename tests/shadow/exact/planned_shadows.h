// planned_shadows.h - exact shadows of points by a chosen plan, and by brute force.
#pragma once

#include "rays/brute_shadows.h"
#include "shadow/exact/point_shadows.h"
#include "shadow/shadow_scenes.h"

#include <cstdint>
#include <vector>

namespace firsthit::test {

/// Which of the points are in shadow (1 or 0), by the given plan.
inline std::vector<std::uint8_t> shadows(const World& world, const PencilSpace& space,
    const ShadowPoints& points, ShadowPlan plan, int threads = 1)
{
    Tasks tasks(threads);
    ShadowMemory memory;
    memory.plan = plan;
    PointSet set;
    make_point_set(points.point, points.receiver, true, set, tasks);
    std::vector<std::uint8_t> shadowed(points.point.size());
    test_points({world, space}, set, memory, tasks, shadowed);
    return shadowed;
}

/// The same by brute force.
inline std::vector<std::uint8_t> plain_shadows(
    const World& world, const PencilSpace& space, const ShadowPoints& points)
{
    const std::vector<glm::vec3> corner = all_to_light(space, world.position);
    const LightTriangles triangles{corner, world.scene->index};
    std::vector<std::uint8_t> shadowed;
    Effort effort;
    for (std::size_t k = 0; k < points.point.size(); ++k) {
        glm::vec3 d = to_light(space, points.point[k]);
        const std::uint32_t receiver = points.receiver[k];
        if (receiver != kNoItem) {
            const Corners c = triangles[receiver];
            d = lifted(space, d, receiver_of(c, light_side(space, c, effort)));
        }
        shadowed.push_back(is_shadowed_brute(space, triangles, d, receiver, effort));
    }
    return shadowed;
}

} // namespace firsthit::test
