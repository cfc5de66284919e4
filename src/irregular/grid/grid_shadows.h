// grid_shadows.h - finds the samples of a grid (sample_grid.h) that triangles shadow. The triangles
// are taken in their own order, without being sorted: for meshes of many triangles, each over a few
// samples.
#pragma once

#include "irregular/cells/cell_kernel.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/grid/sample_grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// The counts of one task, on a cache line of its own.
struct alignas(64) GridTestCounts {
    TestCounts counts;
};

/// Whether consecutive triangles lie along y rather than along x, relative to the size of the
/// bounds. Then the grid's strips should lie along y, so that their samples are read in order.
bool prefers_strips_along_y(
    const PencilMesh& mesh, const CubeFace& face, const SampleBounds& bounds);

/// The samples of a grid, and where the answer goes.
struct GridSamples {
    const SampleGrid& grid;
    const PencilPoints& points;
    std::span<std::uint8_t> shadowed; // by id
};

/// Sets shadowed[id] = 1 for the samples that triangles over few samples shadow, and writes no
/// other element. Exact, as test_cell. The other triangles that may be hit are left in mesh.in_view
/// and mesh.range_count, to be tested by cells; mesh.projected is not filled in.
///
/// mesh     of the face whose samples are in the grid; quantize_all_vertices was called
/// counts   (threads) are added to
/// returns  the number of triangles that are left
std::size_t test_grid(
    PencilMesh& mesh, const GridSamples& samples, std::span<GridTestCounts> counts, Tasks& tasks);

} // namespace firsthit
