// covers.h - large triangles that shadow whole patches and cells: a roof, a wall.
#pragma once

#include "irregular/cover_choice.h"
#include "irregular/leaf.h"
#include "irregular/light_mesh.h"
#include "irregular/patches.h"

#include <span>

namespace firsthit {

/// ranges    into mesh.in_view
/// of_range  memory
CoverList find_covers(const LightMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<CoverList>& of_range, Tasks& tasks);

/// Whether one of the triangles certainly shadows all samples, none of which lies on it.
/// bounds  of the samples
bool is_covered(const LightMesh& mesh, const CoverList& covers, const SampleBounds& bounds,
    std::span<const IrregularSample> samples, const LightPoints& points);

} // namespace firsthit
