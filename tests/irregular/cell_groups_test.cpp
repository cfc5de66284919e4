// cell_groups_test.cpp - the groups of a cell's samples fit into the memory that is allocated for them.
#include "irregular/cells/cell_kernel.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace firsthit::test {
namespace {

struct NoPoints : PencilPoints {
    glm::vec3 in_pencil_space(std::uint32_t) const override { return glm::vec3(0); }
};

/// Ids that make a group of five samples as often as possible, if a group ends before the square (of
/// sixteen ids) of its 16th and 17th sample: samples of two squares take turns, the others are alone in
/// theirs.
std::vector<std::uint32_t> scattered_ids(std::size_t count)
{
    std::vector<std::uint32_t> ids;
    std::map<std::uint32_t, std::uint32_t> used; // of each square
    std::uint32_t squares = 0, even = 0, odd = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (k % 50 == 0) even = squares++, odd = squares++;
        const std::size_t at = k % 10;
        const std::uint32_t square = at == 5 || at == 6 || at == 8   ? even
                                     : at == 0 || at == 1 || at == 3 ? odd
                                                                     : squares++;
        ids.push_back(16 * square + used[square]++);
    }
    return ids;
}

TEST(CellGroups, AreAsFewAsTheirMemoryHoldsForIdsInAnyOrder)
{
    for (const std::size_t count : {17, 64, 200, 2000}) {
        std::vector<IrregularSample> samples;
        for (const std::uint32_t id : scattered_ids(count))
            samples.push_back({float(samples.size()), float(samples.size() % 7), -1, id});
        const SampleBounds bounds{0, 0, float(count), 7, -1, -1};
        PencilMesh mesh;
        mesh.space.directional = true;
        CellKernelMemory memory;
        reserve(memory, 2 * count); // so that groups that are too many corrupt nothing
        std::vector<std::uint8_t> shadowed(16 * 2 * count);
        test_cell(mesh, {samples, bounds, {}, {}}, NoPoints(), memory, shadowed);
        EXPECT_LE(memory.shadowed.size(), most_groups(count)) << count;
    }
}

} // namespace
} // namespace firsthit::test
