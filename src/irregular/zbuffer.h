// zbuffer.h - which points can a light not see? Triangles are rasterised over the points
// as the light sees them, wherever these are: no ray is shot and no tree is built.
//
// Points that came together and lie together stay together: a patch. The points of other patches are
// sorted into the cells of a grid; a cell with many points before many triangles is divided again, so
// that points that crowd together cost little more than others. A patch or cell behind one large
// triangle is done at once. Triangles are sorted into the same patches and cells, where every group
// of sixteen points meets the triangles that may touch it.
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

/// How often a cell may be divided again.
inline constexpr int kCellLevels = 6;

/// One worker's memory.
struct CellWorker {
    CellKernelMemory kernel;
    std::array<IrregularCells, kCellLevels> level;
};

/// Kept from frame to frame.
struct IrregularMemory {
    std::span<const IrregularSample> samples;
    FaceOccluders occluders;
    Buffer<FaceOccluders> occluders_of_range;
    PatchMemory patches;
    IrregularCells cells;
    Buffer<SamplePatch> remaining;    // patches that are not
    Buffer<std::uint8_t> is_occluded; // (patches) while these are told apart
    Buffer<SampleRange> loose;        // samples that go to the cells
    Buffer<SampleRange> occluded;     // samples that one triangle shadows, all of a patch
    std::vector<std::unique_ptr<CellWorker>> workers;
    Buffer<SampleRange> triangle_ranges;
    Tasks serial{1};
};

/// Sorts the samples of one face, and the triangles that find_triangles_in_view found for the same
/// bounds.
/// patches  of `samples`; no two samples have the same id
/// bounds   of all of them
void sort_face(const PencilMesh& mesh, std::span<const IrregularSample> samples,
    std::span<const SamplePatch> patches, const SampleBounds& bounds, const PencilPoints& points,
    IrregularMemory& memory, Tasks& tasks);

/// Tests what was sorted: shadowed[id] = 1 for the samples that are shadowed, no other is written.
/// Adds to the workers' counts.
void test_face(const PencilMesh& mesh, const PencilPoints& points, IrregularMemory& memory,
    Tasks& tasks, std::span<std::uint8_t> shadowed);

} // namespace firsthit
