// face_occluders.h - chooses the triangles that cover the largest areas of one face.
//
// These few triangles are tested first, because one of them often shadows all samples of a patch or
// a cell at once.
#pragma once

#include "irregular/mesh/pencil_mesh.h"

#include <algorithm>
#include <array>
#include <span>

namespace firsthit {

/// The triangles of one face whose boxes cover most of the samples' bounds, in no order.
struct FaceOccluders {
    static constexpr int kMost = 16;
    std::array<ProjectedTriangle, kMost> triangle;
    int count = 0;

    std::span<const ProjectedTriangle> span() const
    {
        return {triangle.data(), std::size_t(count)};
    }
};

/// The area of the bounds that the triangle's box overlaps, in units of the face. Not above 0 where
/// they do not overlap.
inline double overlap_area(const ProjectedTriangle& box, const SampleBounds& bounds)
{
    const auto overlap = [](float low, float high, float from, float to) {
        return std::max(0.0, double(std::min(high, to)) - double(std::max(low, from)));
    };
    return overlap(box.x0, box.x1, bounds.x0, bounds.x1) *
           overlap(box.y0, box.y1, bounds.y0, bounds.y1);
}

/// Is offered triangles one by one and keeps those with the largest overlap_area.
class FaceOccluderChoice {
  public:
    static constexpr double kSmallest = 1.0 / 64; // smaller shares of the bounds are ignored

    explicit FaceOccluderChoice(const SampleBounds& bounds) : bounds_(bounds)
    {
        least_ = kSmallest * (double(bounds.x1) - double(bounds.x0)) *
                 (double(bounds.y1) - double(bounds.y0));
    }

    void offer(const ProjectedTriangle& box)
    {
        if (!(overlap_area(box, bounds_) > least_)) return;
        if (occluders.count < FaceOccluders::kMost) {
            occluders.triangle[std::size_t(occluders.count++)] = box;
            return;
        }
        const auto area = [&](const ProjectedTriangle& s) { return overlap_area(s, bounds_); };
        auto& smallest = *std::min_element(occluders.triangle.begin(), occluders.triangle.end(),
            [&](const auto& a, const auto& b) { return area(a) < area(b); });
        least_ = std::max(least_, area(smallest));
        if (area(box) > area(smallest)) smallest = box;
    }

    FaceOccluders occluders;

  private:
    SampleBounds bounds_;
    double least_;
};

} // namespace firsthit
