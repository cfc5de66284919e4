// occluders.cpp - large triangles that shadow whole patches and cells of samples.
#include "irregular/cells/occluders.h"

#include "irregular/cells/shadowed_box.h"

namespace firsthit {
namespace {

/// Whether one of the samples lies on the triangle.
bool is_item(
    std::uint32_t triangle, std::span<const IrregularSample> samples, const LightPoints& points)
{
    if (!points.item) return false;
    bool found = false;
    const std::size_t between = samples.back().id - std::size_t(samples.front().id);
    if (points.ids_rise && between < 4 * samples.size()) {
        // All lie between two: no need to look at each sample.
        for (std::size_t id = samples.front().id; id <= samples.back().id; ++id)
            found |= points.item[id] == triangle;
    } else {
        for (const IrregularSample& sample : samples) found |= points.item[sample.id] == triangle;
    }
    return found;
}

} // namespace

OccluderList find_occluders(const PencilMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<OccluderList>& of_range, Tasks& tasks)
{
    of_range.resize(ranges.size());
    tasks.for_each(ranges.size(), [&](std::size_t k, std::size_t) {
        OccluderChoice choice(bounds);
        for (const ProjectedTriangle& seen :
            mesh.in_view.span().subspan(ranges[k].first, ranges[k].count))
            choice.offer(seen);
        of_range[k] = choice.occluders;
    });
    OccluderChoice choice(bounds);
    for (const OccluderList& some : of_range.span())
        for (const ProjectedTriangle& seen : some.span()) choice.offer(seen);
    return choice.occluders;
}

bool is_covered(const PencilMesh& mesh, const OccluderList& occluders, const SampleBounds& b,
    std::span<const IrregularSample> samples, const LightPoints& points)
{
    for (int k = 0; k < occluders.count; ++k) {
        const ProjectedTriangle& seen = occluders.triangle[std::size_t(k)];
        const bool around =
            seen.x0 <= b.x0 && seen.x1 >= b.x1 && seen.y0 <= b.y0 && seen.y1 >= b.y1;
        if (around && seen.nearest_w > b.nearest_w &&
            shadows_box(mesh.space, mesh.face, mesh.corners(seen.triangle), b) &&
            !is_item(seen.triangle, samples, points))
            return true;
    }
    return false;
}

} // namespace firsthit
