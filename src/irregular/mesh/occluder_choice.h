// occluder_choice.h - the triangles that cover most of what a light's face sees.
#pragma once

#include "irregular/mesh/pencil_mesh.h"

#include <algorithm>
#include <array>
#include <span>

namespace firsthit {

/// The triangles that cover most of the samples' bounds.
struct OccluderList {
    static constexpr int kMost = 16;
    std::array<ProjectedTriangle, kMost> triangle;
    int count = 0;

    std::span<const ProjectedTriangle> span() const
    {
        return {triangle.data(), std::size_t(count)};
    }
};

/// Of the bounds, by the triangle's box.
inline double covered_area(const ProjectedTriangle& seen, const SampleBounds& bounds)
{
    const auto overlap = [](float low, float high, float from, float to) {
        return std::max(0.0, double(std::min(high, to)) - double(std::max(low, from)));
    };
    return overlap(seen.x0, seen.x1, bounds.x0, bounds.x1) *
           overlap(seen.y0, seen.y1, bounds.y0, bounds.y1);
}

/// Keeps the largest occluders that it is offered.
class OccluderChoice {
  public:
    static constexpr double kSmallest = 1.0 / 64; // of the bounds

    explicit OccluderChoice(const SampleBounds& bounds) : bounds_(bounds)
    {
        least_ = kSmallest * (double(bounds.x1) - double(bounds.x0)) *
                 (double(bounds.y1) - double(bounds.y0));
    }

    void offer(const ProjectedTriangle& seen)
    {
        if (!(covered_area(seen, bounds_) > least_)) return;
        if (occluders.count < OccluderList::kMost) {
            occluders.triangle[std::size_t(occluders.count++)] = seen;
            return;
        }
        const auto area = [&](const ProjectedTriangle& s) { return covered_area(s, bounds_); };
        auto& smallest = *std::min_element(occluders.triangle.begin(), occluders.triangle.end(),
            [&](const auto& a, const auto& b) { return area(a) < area(b); });
        least_ = std::max(least_, area(smallest));
        if (area(seen) > area(smallest)) smallest = seen;
    }

    OccluderList occluders;

  private:
    SampleBounds bounds_;
    double least_;
};

} // namespace firsthit
