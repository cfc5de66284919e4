// cell_kernel.h - tests the samples of one cell of the irregular z-buffer, up to a few thousand,
// against the cell's triangles.
//
// Samples are copied into groups of up to sixteen. A table says which groups a triangle's box
// overlaps; a float filter (set_up-inl.h) tests these groups, and what it cannot decide goes to
// is_shadowed.
#pragma once

#include "base/buffer.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/cells/overlap_table.h"
#include "irregular/mesh/samples.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// The caller's points, which the exact test asks for where the filters cannot decide.
class PencilPoints {
  public:
    virtual ~PencilPoints() = default;
    /// The point with this id (IrregularSample::id) in the pencil's space.
    virtual glm::vec3 in_pencil_space(std::uint32_t id) const = 0;

    /// item[id] is the triangle that the point lies on, which never shadows it. Null: no point is
    /// known to lie on a triangle.
    const std::uint32_t* item = nullptr;

    /// Whether the ids of the samples of a patch rise with their index.
    bool ids_rise = false;
};

/// How much work the tests were.
struct TestCounts {
    std::uint64_t triangles = 0; // set-ups of a triangle; a triangle is set up once for each cell
    std::uint64_t pairs = 0;     // tested pairs of a sample and a triangle
    std::uint64_t uncertain = 0; // pairs that the filters left to the exact test
    Effort effort;

    void add(const TestCounts& other)
    {
        triangles += other.triangles;
        pairs += other.pairs;
        uncertain += other.uncertain;
        effort.exact_calls += other.effort.exact_calls;
    }
};

inline constexpr int kGroup = 16;     // lanes of a group; it has up to as many samples
inline constexpr int kCellBatch = 64; // triangles that are set up together

/// Triangles that are set up for one cell, structure of arrays. Edges and w are affine functions of
/// a sample's offset (x, y) from the cell's middle: edge k is gx[k] x + gy[k] y + c[k], positive
/// inside the triangle and scaled so that it is at most 1 in size over the cell; w is wx x + wy y +
/// wc.
struct CellBatch {
    int count = 0;
    alignas(64) std::uint32_t triangle[kCellBatch];
    TriangleSlots slots[kCellBatch];
    alignas(64) float corner[9][kCellBatch]; // a0 b0 c0 a1 ... in the axes of the face
    alignas(64) float gx[3][kCellBatch], gy[3][kCellBatch], c[3][kCellBatch];
    alignas(64) float wx[kCellBatch], wy[kCellBatch], wc[kCellBatch];
    /// Bounds of (the triangle's w at the sample) - (the sample's w): a sample inside the edges is
    /// certainly shadowed above the one and certainly not shadowed below the other.
    alignas(64) float shadowed_from[kCellBatch];
    alignas(64) float lit_below[kCellBatch];
};

/// The minimum of x, -x, y and -y over a group's samples: x0, -x1, y0, -y1.
struct GroupBox {
    float side[4];
};

/// One worker's memory. While a cell is tested it holds the cell's samples in groups of kGroup
/// lanes. The lanes after a group's last sample lie where its first sample lies, with infinite w.
struct CellKernelMemory {
    Buffer<float> x, y, w;         // (groups, kGroup) x and y are offsets from the cell's middle
    Buffer<std::uint32_t> item;    // (groups, kGroup) undefined for groups without has_item
    Buffer<std::uint8_t> has_item; // (groups) 1: `item` of the group has been filled in
    Buffer<std::uint32_t> first;   // (groups + 1) index of the group's first sample
    Buffer<std::uint16_t>
        shadowed;               // (groups) a bit for each lane; always set after the last sample
    Buffer<GroupBox> box;       // (groups) of the samples' offsets
    Buffer<OverlapTable> table; // (chunks) a chunk is 64 groups
    CellBatch batch;
    TestCounts counts;

    // Of the cell, in units of the face (CubeFace), see start_cell.
    SampleBounds bounds;
    float largest_w = 0; // the largest |w| of a sample
    float middle_x = 0, middle_y = 0;
    double half_x = 0, half_y = 0;   // the largest |x| and |y| of an offset
    double error_x = 0, error_y = 0; // of a sample's x and y, because they are rounded
    /// Bounds of the margins over c (over 1 in a parallel pencil) of all samples. A triangle adds
    /// the corner terms times its largest coordinate (corner_margin).
    double least_margin = 0, largest_margin = 0;
    double least_corner = 0, largest_corner = 0;
};

/// An upper bound of the number of groups that so many samples make: any two consecutive groups
/// have more than kGroup samples together.
inline std::size_t most_groups(std::size_t samples)
{
    return samples / (kGroup / 2) + 2;
}

/// Allocates room for cells of up to so many samples.
void reserve(CellKernelMemory& memory, std::size_t samples);

/// The samples and triangles of one cell.
struct CellWork {
    std::span<const IrregularSample> samples;
    SampleBounds bounds; // of the samples
    std::span<const ProjectedTriangle> triangles;
    /// Large triangles of the face. They are tested before the others, because samples that are
    /// shadowed need no more tests. They may be among `triangles` too.
    std::span<const ProjectedTriangle> occluders;
};

/// Sets shadowed[id] = 1 for the samples of the cell that a triangle shadows, and writes no other
/// element. Exact: the answer is that of is_shadowed for each sample and each triangle except the
/// sample's own (PencilPoints::item).
void test_cell(const PencilMesh& mesh, const CellWork& work, const PencilPoints& points,
    CellKernelMemory& memory, std::span<std::uint8_t> shadowed);

} // namespace firsthit
