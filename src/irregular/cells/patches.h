// patches.h - samples that already lie together as the light sees them: they need no
// sorting, only their triangles do.
#pragma once

#include "irregular/mesh/bin_triangles.h"
#include "irregular/cells/overlap_table.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Samples of one face that came together, as from one tile of the picture.
struct SamplePatch {
    SampleRange range;
    SampleBounds bounds;
};

/// Whether testing a patch as it is costs less than sorting its samples: neighbours in the picture
/// are mostly neighbours for the light too.
/// all, triangles  of the whole face: bounds and number
bool is_compact(const SamplePatch& patch, const SampleBounds& all, std::size_t triangles);

/// Kept from frame to frame.
struct PatchMemory {
    Buffer<SamplePatch> patches;
    Buffer<OverlapTable> tables; // of 64 patches each
    TriangleBins bins;           // by patch
};

/// Copies each triangle to all patches whose samples it may shadow. memory.patches are given.
/// Returns what bin_triangles does.
bool bin_patches(std::span<const ProjectedTriangle> from, std::span<const SampleRange> ranges,
    const SampleBounds& all, PatchMemory& memory, Tasks& tasks);

} // namespace firsthit
