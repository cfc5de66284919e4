// patches.cpp - patches of samples that are tested without being sorted into cells.
#include "irregular/cells/patches.h"

#include <bit>

namespace firsthit {

bool is_compact(const SamplePatch& patch, const SampleBounds& all, std::size_t triangles)
{
    const auto area = [](const SampleBounds& b) {
        return (double(b.x1) - double(b.x0)) * (double(b.y1) - double(b.y0));
    };
    const double whole = area(all);
    const double share = whole > 0 ? area(patch.bounds) / whole : 0;
    const double count = double(patch.range.count);
    // Measured: testing a patch as it is pays if it has at most 1/16 as many triangles as samples,
    // the triangles being estimated by the patch's share of the area.
    return share * double(triangles) <= count / 16;
}

bool bin_patches(
    const TriangleRanges& from, const SampleBounds& all, PatchMemory& memory, Tasks& tasks)
{
    const std::size_t count = memory.patches.size();
    const BoxSlots slots(all);
    memory.tables.resize((count + kTableBoxes - 1) / kTableBoxes);
    for (std::size_t k = 0; k < memory.tables.size(); ++k) {
        OverlapTable& table = memory.tables[k];
        table = {};
        const std::size_t first = k * kTableBoxes,
                          last = std::min<std::size_t>(count, first + kTableBoxes);
        for (std::size_t patch = first; patch < last; ++patch)
            table.add(int(patch - first), memory.patches[patch].bounds, slots);
        table.finish();
    }
    const auto for_patches = [&](std::size_t k, const auto& f) {
        const ProjectedTriangle& box = from.array[k];
        const TriangleSlots triangle_slots(box, slots);
        for (std::size_t table = 0; table < memory.tables.size(); ++table) {
            std::uint64_t rest = memory.tables[table].of(triangle_slots);
            for (; rest; rest &= rest - 1) {
                const std::size_t patch = table * kTableBoxes + std::size_t(std::countr_zero(rest));
                if (may_hit(box, memory.patches[patch].bounds)) f(patch);
            }
        }
    };
    const TriangleRanges wanted{
        from.array, count == 0 ? std::span<const SampleRange>() : from.ranges};
    return bin_triangles(wanted, count, for_patches, memory.bins, tasks);
}

} // namespace firsthit
