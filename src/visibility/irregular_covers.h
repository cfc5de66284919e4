// irregular_covers.h - large triangles that shadow whole patches and cells: a roof, a wall.
#pragma once

#include "visibility/irregular_leaf.h"
#include "visibility/irregular_patches.h"
#include "visibility/light_mesh.h"

#include <array>
#include <span>

namespace firsthit {

/// The triangles that cover most of the samples' bounds.
struct CoverList {
    static constexpr int kMost = 16;
    std::array<SeenTriangle, kMost> triangle;
    int count = 0;

    std::span<const SeenTriangle> span() const { return {triangle.data(), std::size_t(count)}; }
};

/// ranges    into mesh.in_view
/// of_range  memory
CoverList find_covers(const LightMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<CoverList>& of_range, Tasks& tasks);

/// Whether one of the triangles certainly shadows all samples, none of which lies on it.
/// bounds  of the samples
bool is_covered(const LightMesh& mesh, const CoverList& covers, const SampleBounds& bounds,
    std::span<const IrregularSample> samples, const LightPoints& points);

} // namespace firsthit
