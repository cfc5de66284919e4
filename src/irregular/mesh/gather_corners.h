// gather_corners.h - the corners of a batch of triangles as a light's face sees them.
#pragma once

#include "irregular/mesh/pencil_mesh.h"

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// corner[3 k + axis][i] = coordinate `axis` of corner k of triangle[i]. One load at a time: where
/// registers can gather, it takes them longer (measured on Zen 5).
template <std::size_t kRoom>
inline void gather_corners(const PencilMesh& mesh, const CubeFace& face, int count,
    const std::uint32_t* triangle, float (&corner)[9][kRoom])
{
    const glm::vec3* position = mesh.corner.data();
    constexpr int kAhead = 12; // triangles: their memory is asked for while others are copied
    for (int i = 0; i < count; ++i) __builtin_prefetch(&mesh.index[triangle[i]]);
    for (int i = -kAhead; i < count; ++i) {
        if (i + kAhead < count) {
            const glm::uvec3& index = mesh.index[triangle[i + kAhead]];
            for (int k = 0; k < 3; ++k) __builtin_prefetch(&position[index[k]]);
        }
        if (i < 0) continue;
        const std::uint32_t* index = &mesh.index[triangle[i]].x;
        for (int k = 0; k < 3; ++k) {
            const float* p = &position[index[k]].x;
            corner[3 * k][i] = p[face.axis_a];
            corner[3 * k + 1][i] = p[face.axis_b];
            corner[3 * k + 2][i] = p[face.axis_c] * face.sign;
        }
    }
}

} // namespace firsthit
