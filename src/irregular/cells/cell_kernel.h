// cell_kernel.h - a few thousand samples of the irregular z-buffer against the triangles of
// their cell.
#pragma once

#include "base/buffer.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/cells/overlap_table.h"
#include "irregular/mesh/samples.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// What the caller knows of its points, asked for where the filters cannot tell.
class PencilPoints {
  public:
    virtual ~PencilPoints() = default;
    /// The point in the light's space.
    virtual glm::vec3 in_pencil_space(std::uint32_t id) const = 0;

    /// The triangle each point lies on, by id, which does not shadow it; or null.
    const std::uint32_t* item = nullptr;

    /// Samples that come together have rising ids.
    bool ids_rise = false;
};

/// How much work the samples took.
struct TestCounts {
    std::uint64_t triangles = 0; // set up, once for each cell
    std::uint64_t pairs = 0;     // of a sample and a triangle, tested
    std::uint64_t uncertain = 0; // of these, left open by the filters
    Effort effort;

    void add(const TestCounts& other)
    {
        triangles += other.triangles;
        pairs += other.pairs;
        uncertain += other.uncertain;
        effort.exact_calls += other.effort.exact_calls;
    }
};

inline constexpr int kGroup = 16;     // samples that are tested at once, at most
inline constexpr int kCellBatch = 64; // triangles that are set up together

/// Structure of arrays. Edges and w are affine in the sample's offset from the cell's middle.
struct CellBatch {
    int count = 0;
    alignas(64) std::uint32_t triangle[kCellBatch];
    TriangleSlots slots[kCellBatch];
    alignas(64) float corner[9][kCellBatch]; // a0 b0 c0 a1 ... as the face sees them
    alignas(64) float gx[3][kCellBatch], gy[3][kCellBatch],
        c[3][kCellBatch]; // |e| <= 1, inside > 0
    alignas(64) float wx[kCellBatch], wy[kCellBatch], wc[kCellBatch];
    alignas(64) float shadowed_from[kCellBatch]; // w - sample's w: certainly shadowed above this,
    alignas(64) float lit_below[kCellBatch];     // certainly not below that
};

/// The least x, -x, y and -y of a group's samples.
struct GroupBox {
    float side[4];
};

/// One worker's memory, and its samples while it is at a cell.
struct CellKernelMemory {
    Buffer<float> x, y, w;          // offsets from the middle; whole groups
    Buffer<std::uint32_t> item;     // of the groups whose has_item is set
    Buffer<std::uint8_t> has_item;  // (groups)
    Buffer<std::uint32_t> first;    // (groups + 1) number of its first sample
    Buffer<std::uint16_t> shadowed; // (groups) a bit for each lane; set beyond its samples
    Buffer<GroupBox> box;           // (groups) of its samples' offsets
    Buffer<OverlapTable> table;     // (chunks) of 64 groups
    CellBatch batch;
    TestCounts counts;

    // The cell.
    SampleBounds bounds;
    float largest_w = 0; // the largest size of a w
    float middle_x = 0, middle_y = 0;
    double half_x = 0, half_y = 0;               // largest offsets
    double error_x = 0, error_y = 0;             // of a sample's place
    double least_margin = 0, largest_margin = 0; // in units of w times the plane's distance
    double least_corner = 0, largest_corner = 0; // the same, for a triangle's corner at distance 1
};

/// Groups of so many samples: of two groups in a row, one alone would not hold all.
inline std::size_t most_groups(std::size_t samples)
{
    return samples / (kGroup / 2) + 2;
}

/// Room for cells of so many samples.
void reserve(CellKernelMemory& memory, std::size_t samples);

/// One cell.
struct CellWork {
    std::span<const IrregularSample> samples;
    SampleBounds bounds; // of the samples
    std::span<const ProjectedTriangle> triangles;
    std::span<const ProjectedTriangle>
        occluders; // large ones of the face: what they shadow is done with
};

/// Finds out which samples of the cell are shadowed: shadowed[id] = 1 for these, no other is
/// written. Exact: the answer is that of is_shadowed for each sample and each triangle but its own.
void test_cell(const PencilMesh& mesh, const CellWork& work, const PencilPoints& points,
    CellKernelMemory& memory, std::span<std::uint8_t> shadowed);

} // namespace firsthit
