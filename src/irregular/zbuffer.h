// zbuffer.h - the irregular z-buffer: finds which points are shadowed, exactly, by rasterising
// triangles over the points' projections to a face of the pencil, wherever these lie. It needs
// neither rays nor a tree.
//
// Points that came together (a patch) and lie close together on the face stay together. The points
// of other patches are sorted into the cells of a grid; a cell with many points and many triangles
// is divided again, so that crowded points cost little more than others. Triangles are sorted into
// the same patches and cells, where each group of up to sixteen points is tested against the
// triangles that may overlap it. A patch or cell that one large triangle shadows as a whole is
// finished at once.
//
// source  Johnson et al. 2005, "The Irregular Z-Buffer: Hardware Acceleration for Irregular Data
//         Structures", ACM Transactions on Graphics 24(4); Aila and Laine 2004, "Alias-Free Shadow
//         Maps", Eurographics Symposium on Rendering
#pragma once

#include "irregular/cells/cells.h"
#include "irregular/cells/occluded_samples.h"
#include "irregular/cells/cell_kernel.h"
#include "irregular/cells/patches.h"

#include <array>
#include <memory>
#include <vector>

namespace firsthit {

/// How many times a cell may be divided again.
inline constexpr int kCellLevels = 6;

/// One worker's memory.
struct CellWorker {
    CellKernelMemory kernel;
    std::array<IrregularCells, kCellLevels> level; // the cells of a divided cell, by depth
};

/// The sorted samples and triangles of one face. The memory is kept from frame to frame.
struct IrregularMemory {
    std::span<const IrregularSample> samples;
    FaceOccluders occluders;
    Buffer<FaceOccluders> occluders_of_range;
    PatchMemory patches;
    IrregularCells cells;
    Buffer<SamplePatch> remaining;    // the other patches
    Buffer<std::uint8_t> is_occluded; // (patches) used only while these are divided
    Buffer<SampleRange> loose;        // samples that are sorted into cells
    Buffer<SampleRange> occluded;     // patches that one occluder shadows as a whole
    std::vector<std::unique_ptr<CellWorker>> workers;
    Buffer<SampleRange> triangle_ranges;
    Tasks serial{1};
};

/// Sorts the samples of one face, and the triangles of mesh.in_view.
///
/// mesh     of the face; find_triangles_in_view was called with the same bounds, or test_grid left
///          the triangles and project_all_vertices was called
/// patched  what its spans name must outlive the call of test_face
void sort_face(const PencilMesh& mesh, const PatchedSamples& patched, const PencilPoints& points,
    IrregularMemory& memory, Tasks& tasks);

/// Tests what sort_face sorted: sets shadowed[id] = 1 for the samples that are shadowed, and writes
/// no other element. Adds to the workers' counts.
void test_face(const PencilMesh& mesh, const PencilPoints& points, IrregularMemory& memory,
    Tasks& tasks, std::span<std::uint8_t> shadowed);

} // namespace firsthit
