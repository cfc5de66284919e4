// occluders.h - large triangles that shadow whole patches and cells: a roof, a wall.
#pragma once

#include "irregular/mesh/face_occluders.h"
#include "irregular/cells/cell_kernel.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/cells/patches.h"

#include <span>

namespace firsthit {

/// ranges    into mesh.in_view
/// of_range  memory
FaceOccluders find_face_occluders(const PencilMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<FaceOccluders>& of_range, Tasks& tasks);

/// Whether one of the triangles certainly shadows all samples, none of which lies on it.
/// bounds  of the samples
bool is_occluded(const PencilMesh& mesh, const FaceOccluders& occluders, const SampleBounds& bounds,
    std::span<const IrregularSample> samples, const PencilPoints& points);

} // namespace firsthit
