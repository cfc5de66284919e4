// grid_shadows.h - which samples of a grid do triangles shadow? One after the other, in their own
// order, without being sorted: for meshes of many triangles, each over a few samples.
#pragma once

#include "irregular/cells/cell_kernel.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/grid/sample_grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// One task's counts, on cache lines of their own.
struct alignas(64) GridTestCounts {
    TestCounts counts;
};

/// Whether triangles with consecutive numbers lie along y more than along x, in shares of the bounds:
/// then strips along y are read from end to end.
bool prefers_strips_along_y(
    const PencilMesh& mesh, const CubeFace& face, const SampleBounds& bounds);

/// Tests the triangles that lie over few cells: shadowed[id] = 1 for the samples that these shadow,
/// no other is written. Exact, as test_cell. The others that may shadow a sample are left in
/// mesh.in_view and mesh.range_count. Returns how many these are.
///
/// mesh     of the face whose samples are in the grid; quantize_all_vertices has filled in `place`
/// counts   (threads)
std::size_t test_grid(PencilMesh& mesh, const SampleGrid& grid, const PencilPoints& points,
    std::span<GridTestCounts> counts, Tasks& tasks, std::span<std::uint8_t> shadowed);

} // namespace firsthit
