// patches.h - patches of samples: samples that came together, from one tile of the picture, and
// mostly lie close together on the face too. A compact patch is tested as it is; only the triangles
// are sorted.
#pragma once

#include "irregular/mesh/bin_triangles.h"
#include "irregular/cells/overlap_table.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Whether testing a patch as it is costs less than sorting its samples into cells.
///
/// all        the bounds of all samples of the face
/// triangles  the number of triangles of the face
bool is_compact(const SamplePatch& patch, const SampleBounds& all, std::size_t triangles);

/// The compact patches of a face and their triangles. The memory is kept from frame to frame.
struct PatchMemory {
    Buffer<SamplePatch> patches;
    Buffer<OverlapTable> tables; // table k has the patches from number 64 k on
    TriangleBins bins;           // by patch
};

/// Fills in memory.bins for memory.patches: each triangle is copied to all patches to whose samples
/// a ray may hit it (may_hit). Returns false, and sorts nothing, if that took too many copies
/// (bin_triangles).
///
/// all  the bounds of all samples of the face
bool bin_patches(
    const TriangleRanges& from, const SampleBounds& all, PatchMemory& memory, Tasks& tasks);

} // namespace firsthit
