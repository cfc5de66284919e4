// project_points_to_face.h - sorts points of a pencil's space by face and projects them to samples.
#pragma once

#include "exact/shadow_ray.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <array>
#include <span>

namespace firsthit {

/// Points of the pencil's space, structure of arrays. One worker's memory.
struct PointChunk {
    Buffer<float> x, y, z;
    Buffer<std::uint32_t> id; // see IrregularSample
    std::size_t count = 0;

    /// Allocates room for `points` points and a whole register after the last one.
    void reserve(std::size_t points)
    {
        for (auto* values : {&x, &y, &z}) values->resize(points + 16);
        id.resize(points + 16);
    }
};

/// The samples of one chunk on each face; empty where it has none.
using FacePatches = std::array<SamplePatch, kCubeFaces>;

/// How many samples a chunk of `points` points may write: up to a register more than it has. Chunks
/// that are written at the same time start this far apart.
inline std::size_t chunk_room(std::size_t points)
{
    return points + 16;
}

/// Writes the chunk's points as samples, face by face, from index `first` on. Points that project
/// to the mesh's wide face are samples of that face, the others of the face of their largest
/// coordinate. Points without a ray (has_shadow_ray) are left out.
///
/// patches  out: range and bounds of the samples of each face
void project_points_to_face(const PencilMesh& mesh, const PointChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FacePatches& patches);

} // namespace firsthit
