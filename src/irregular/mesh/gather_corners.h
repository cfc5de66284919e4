// gather_corners.h - loads the corners of a batch of triangles, in the axes of a face.
#pragma once

#include "irregular/mesh/pencil_mesh.h"

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// corner[3 k + axis][i] = coordinate `axis` (0 to 2: a, b, c of CubeFace) of corner k of
/// triangle[i]. The loads are scalar, because gather instructions were slower (measured on Zen 5).
template <std::size_t kCapacity>
inline void gather_corners(const PencilMesh& mesh, const CubeFace& face, int count,
    const std::uint32_t* triangle, float (&corner)[9][kCapacity])
{
    const glm::vec3* position = mesh.corner.data();
    constexpr int kAhead = 12; // triangles: how far ahead of the copy corners are prefetched
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
