// occluded_samples.cpp - finds patches and cells of samples that one large triangle shadows as a
// whole.
#include "irregular/cells/occluded_samples.h"

#include "irregular/cells/shadowed_box.h"

namespace firsthit {
namespace {

/// Whether one of the samples lies on the triangle. There must be at least one sample.
bool is_item(
    std::uint32_t triangle, std::span<const IrregularSample> samples, const PencilPoints& points)
{
    if (!points.item) return false;
    bool found = false;
    const std::size_t between = samples.back().id - std::size_t(samples.front().id);
    if (points.ids_rise && between < 4 * samples.size()) {
        // The ids lie between the first and the last one: reading the items in order is faster than
        // reading the samples, and the few ids that are no samples can only make the answer true.
        for (std::size_t id = samples.front().id; id <= samples.back().id; ++id)
            found |= points.item[id] == triangle;
    } else {
        for (const IrregularSample& sample : samples) found |= points.item[sample.id] == triangle;
    }
    return found;
}

} // namespace

FaceOccluders find_face_occluders(const PencilMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<FaceOccluders>& of_range, Tasks& tasks)
{
    of_range.resize(ranges.size());
    const bool any_cutouts = mesh.cutouts.any();
    tasks.for_each(ranges.size(), [&](std::size_t k, std::size_t) {
        FaceOccluderChoice choice(bounds);
        for (const ProjectedTriangle& box :
            mesh.in_view.span().subspan(ranges[k].first, ranges[k].count))
            if (!any_cutouts || !mesh.cutouts.has(box.triangle)) choice.offer(box);
        of_range[k] = choice.occluders;
    });
    FaceOccluderChoice choice(bounds);
    for (const FaceOccluders& some : of_range.span())
        for (const ProjectedTriangle& box : some.span()) choice.offer(box);
    return choice.occluders;
}

bool is_occluded(const PencilMesh& mesh, const FaceOccluders& occluders, const SampleBounds& b,
    std::span<const IrregularSample> samples, const PencilPoints& points)
{
    for (int k = 0; k < occluders.count; ++k) {
        const ProjectedTriangle& box = occluders.triangle[std::size_t(k)];
        const bool around = box.x0 <= b.x0 && box.x1 >= b.x1 && box.y0 <= b.y0 && box.y1 >= b.y1;
        if (around && box.nearest_w > b.nearest_w &&
            shadows_box(mesh.space, mesh.face, mesh.corners(box.triangle), b) &&
            !is_item(box.triangle, samples, points))
            return true;
    }
    return false;
}

} // namespace firsthit
