// occluded_samples.h - finds patches and cells of samples that one large triangle, such as a roof
// or a wall, shadows as a whole.
#pragma once

#include "irregular/mesh/face_occluders.h"
#include "irregular/cells/cell_kernel.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/cells/patches.h"

#include <span>

namespace firsthit {

/// The triangles of mesh.in_view that cover the largest areas of the bounds.
///
/// ranges    of indices into mesh.in_view
/// of_range  scratch memory
FaceOccluders find_face_occluders(const PencilMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<FaceOccluders>& of_range, Tasks& tasks);

/// Whether one of the occluders certainly shadows all samples, and none of the samples lies on it.
/// False where that is not certain.
///
/// bounds   of the samples
/// samples  at least one
bool is_occluded(const PencilMesh& mesh, const FaceOccluders& occluders, const SampleBounds& bounds,
    std::span<const IrregularSample> samples, const PencilPoints& points);

} // namespace firsthit
