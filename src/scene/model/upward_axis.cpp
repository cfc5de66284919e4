// upward_axis.cpp - which way is up, by the flat bottom that a model rests on.
#include <firsthit/framing.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

/// The share of the bounding box's lower side, in the direction of an axis, that triangles cover which lie
/// there flat: all their corners are within a hundredth of the box's extent.
double resting_share(const World& world, int axis, const std::array<glm::dvec3, 2>& box)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::dvec3 extent = box[1] - box[0];
    const double floor = extent[u] * extent[v];
    if (!(floor > 0) || !(extent[axis] > 0)) return 0;
    const double highest = box[0][axis] + extent[axis] / 100;
    double area = 0;
    for (const glm::uvec3& t : world.scene->index) {
        const glm::dvec3 a(world.position[t.x]), b(world.position[t.y]), c(world.position[t.z]);
        if (!(a[axis] <= highest && b[axis] <= highest && c[axis] <= highest)) continue;
        area += std::abs((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) / 2;
    }
    return area / floor;
}

} // namespace

glm::dvec3 upward_axis(const World& world, const glm::dvec3& usual)
{
    constexpr glm::dvec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (usual != kAxes[1] && usual != kAxes[2]) return usual;
    std::array<glm::dvec3, 2> box{glm::dvec3(std::numeric_limits<double>::infinity()),
        glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (const glm::vec3& p : world.position) {
        box[0] = glm::min(box[0], glm::dvec3(p));
        box[1] = glm::max(box[1], glm::dvec3(p));
    }
    constexpr double kRests = 0.01, kMuchMore = 4;
    const int axis = usual.z != 0 ? 2 : 1, other = 3 - axis;
    const double along_other = resting_share(world, other, box);
    if (along_other < kRests) return usual;
    return along_other > kMuchMore * resting_share(world, axis, box) ? kAxes[other] : usual;
}

} // namespace firsthit
