// triangle_box.h - the samples that a triangle may hit, from those of its corners.
#pragma once

#include "visibility/bin/careful_box.h"
#include "visibility/bin/view_memory.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace firsthit {

/// A corner in eye space, whatever it is stored as; of a flat one within float's roundings.
inline glm::vec3 eye_corner(const ViewMemory& memory, std::uint32_t vertex)
{
    const glm::vec4& v = memory.corner[vertex];
    const bool is_eye = memory.corner_space == CornerSpace::eye ||
                        std::bit_cast<VertexSamples>(v.w).x == VertexSamples::kBehind;
    return is_eye ? glm::vec3(v) : glm::vec3(v.x / v.z, v.y / v.z, 1 / v.z);
}

/// At most the least z of corners that are all in front of the eye.
inline float nearest_z(const ViewMemory& memory, const glm::uvec3& index)
{
    const auto z = [&](std::uint32_t vertex) { return memory.corner[vertex].z; };
    if (memory.corner_space == CornerSpace::eye)
        return std::min({z(index.x), z(index.y), z(index.z)});
    // Smaller than rounding twice may have made it.
    return (1 - 0x1p-20f) / std::max({z(index.x), z(index.y), z(index.z)});
}

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
        const auto found = careful_box(triangle,
            {eye_corner(memory, index.x), eye_corner(memory, index.y), eye_corner(memory, index.z)},
            memory.pencil);
        if (found) box = *found;
        return found.has_value();
    }
    const int x0 = VertexSamples::first(least_x),
              y0 = VertexSamples::first(std::min({p.y, q.y, r.y}));
    const int x1 = VertexSamples::last(std::max({p.x, q.x, r.x}));
    const int y1 = VertexSamples::last(std::max({p.y, q.y, r.y}));
    if (x0 > x1 || y0 > y1) return false;
    box = {triangle, std::int16_t(x0), std::int16_t(y0), std::int16_t(x1), std::int16_t(y1),
        nearest_z(memory, index)};
    return true;
}

} // namespace firsthit
