// point_tree.cpp - finds those of many points of a plane that lie near a triangle.
#include "readers/mesh/point_tree.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace firsthit {

PointTree::PointTree(std::span<const glm::dvec2> point, std::vector<std::uint32_t> chosen)
    : point_(point),
      chosen_(std::move(chosen))
{
    // Halves of n points have at most (n + 1) / 2, so that no part is deeper than in a full tree.
    const std::size_t leaves = std::bit_ceil(chosen_.size() / kLeaf + 1);
    boxes_.resize(4 * leaves);
    if (!chosen_.empty()) build({.first = 0, .end = chosen_.size(), .box = 1});
}

void PointTree::build(const Part& part)
{
    Box& box = boxes_[part.box];
    box = {.low = point_[chosen_[part.first]], .high = point_[chosen_[part.first]]};
    for (std::size_t k = part.first; k < part.end; ++k) {
        box.low = glm::min(box.low, point_[chosen_[k]]);
        box.high = glm::max(box.high, point_[chosen_[k]]);
    }
    if (part.is_leaf()) return;
    const glm::dvec2 size = box.high - box.low;
    const int axis = size.x >= size.y ? 0 : 1;
    const auto at = [&](std::size_t k) { return chosen_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(part.first), at(part.lower().end), at(part.end),
        [&](std::uint32_t a, std::uint32_t b) { return point_[a][axis] < point_[b][axis]; });
    build(part.lower());
    build(part.upper());
}

/// Whether a box lies on the outer side of a side of the triangle, or of its box. Never wrongly true.
bool PointTree::is_apart(const Box& box, const std::array<glm::dvec2, 3>& triangle)
{
    const glm::dvec2 low = glm::min(glm::min(triangle[0], triangle[1]), triangle[2]);
    const glm::dvec2 high = glm::max(glm::max(triangle[0], triangle[1]), triangle[2]);
    if (box.high.x < low.x || box.low.x > high.x || box.high.y < low.y || box.low.y > high.y)
        return true;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2& a = triangle[k];
        const glm::dvec2 side = triangle[(k + 1) % 3] - a;
        // The corner of the box that is farthest to the side's left, where the triangle is.
        const double x = (side.y > 0 ? box.low.x : box.high.x) - a.x;
        const double y = (side.x > 0 ? box.high.y : box.low.y) - a.y;
        const double left = side.x * y - side.y * x;
        // Far more than these few roundings can make.
        if (left < -1e-14 * (std::abs(side.x * y) + std::abs(side.y * x))) return true;
    }
    return false;
}

} // namespace firsthit
