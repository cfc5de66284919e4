// triangle_box.h - the samples that a triangle may hit, from those of its corners.
#pragma once

#include "visibility/careful_box.h"
#include "visibility/view_memory.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace firsthit {

/// Whether the triangle may hit a sample, and a box that holds all such, from where its corners
/// stand among the samples.
///
/// index  the triangle's entry of the index
inline bool box_of(
    std::uint32_t triangle, const glm::uvec3& index, const ViewMemory& memory, InView& box)
{
    const glm::vec4 &a = memory.corner[index.x], &b = memory.corner[index.y],
                    &c = memory.corner[index.z];
    const auto samples = [](const glm::vec4& v) { return std::bit_cast<VertexSamples>(v.w); };
    const VertexSamples p = samples(a), q = samples(b), r = samples(c);
    const std::int16_t least_x = std::min({p.x, q.x, r.x});
    if (least_x == VertexSamples::kBehind) [[unlikely]] {
        const auto found =
            careful_box(triangle, {glm::vec3(a), glm::vec3(b), glm::vec3(c)}, memory.pencil);
        if (found) box = *found;
        return found.has_value();
    }
    const int x0 = VertexSamples::first(least_x),
              y0 = VertexSamples::first(std::min({p.y, q.y, r.y}));
    const int x1 = VertexSamples::last(std::max({p.x, q.x, r.x}));
    const int y1 = VertexSamples::last(std::max({p.y, q.y, r.y}));
    if (x0 > x1 || y0 > y1) return false;
    box = {triangle, std::int16_t(x0), std::int16_t(y0), std::int16_t(x1), std::int16_t(y1),
        std::min({a.z, b.z, c.z})};
    return true;
}

} // namespace firsthit
