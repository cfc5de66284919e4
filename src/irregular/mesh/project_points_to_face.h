// project_points_to_face.h - points in a light's space to the faces that see them.
#pragma once

#include "exact/shadow_ray.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/cells/patches.h"
#include "irregular/mesh/samples.h"

#include <array>
#include <span>

namespace firsthit {

/// Some points in the light's space, structure of arrays; a worker's memory.
struct LightChunk {
    Buffer<float> x, y, z;
    Buffer<std::uint32_t> id; // see IrregularSample
    std::size_t count = 0;

    /// Room for `points` and a register more.
    void reserve(std::size_t points)
    {
        for (auto* values : {&x, &y, &z}) values->resize(points + 16);
        id.resize(points + 16);
    }
};

/// Where the samples of each face went.
using FaceParts = std::array<SamplePatch, kLightFaces>;

/// Samples that a chunk of `points` may overwrite: place chunks this far apart.
inline std::size_t chunk_room(std::size_t points)
{
    return points + 16;
}

/// Writes the chunk's points as samples from number `first` on, face by face: to the mesh's wide face
/// what that sees. Points without a shadow ray (has_shadow_ray) are left out.
void project_points_to_face(const PencilMesh& mesh, const LightChunk& chunk, std::size_t first,
    std::span<IrregularSample> samples, FaceParts& parts);

} // namespace firsthit
