// triangle_box.h - the samples that a triangle may hit, from those of its corners.
#pragma once

#include "visibility/careful_box.h"
#include "visibility/view_memory.h"

#include <algorithm>
#include <cstdint>

namespace firsthit {

/// Whether the triangle may hit a sample, and a box that holds all such: the corners' boxes decide
/// in three loads and two minima (saturation is not needed: first <= 8192, minus_last <= 1).
///
/// corner  the triangle's entry of the index
inline bool box_of(
    std::uint32_t triangle, const glm::uvec3& corner, const ViewMemory& memory, InView& box)
{
    const VertexBox &a = memory.box[corner.x], &b = memory.box[corner.y], &c = memory.box[corner.z];
    const std::int16_t x0 = std::min({a.first_x, b.first_x, c.first_x});
    const std::int16_t y0 = std::min({a.first_y, b.first_y, c.first_y});
    const std::int16_t mx1 = std::min({a.minus_last_x, b.minus_last_x, c.minus_last_x});
    const std::int16_t my1 = std::min({a.minus_last_y, b.minus_last_y, c.minus_last_y});
    if (x0 == VertexBox::kBehind) [[unlikely]] {
        const auto eye = [&](std::uint32_t v) { return glm::vec3(memory.corner[v]); };
        const auto found =
            careful_box(triangle, {eye(corner.x), eye(corner.y), eye(corner.z)}, memory.pencil);
        if (found) box = *found;
        return found.has_value();
    }
    if (x0 + mx1 > 0 || y0 + my1 > 0) return false;
    const auto z = [&](std::uint32_t v) { return memory.corner[v].z; };
    box = {triangle, x0, y0, std::int16_t(-mx1), std::int16_t(-my1),
        std::min({z(corner.x), z(corner.y), z(corner.z)})};
    return true;
}

} // namespace firsthit
