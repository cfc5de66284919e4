// cover_choice.h - the triangles that cover most of what a light's face sees.
#pragma once

#include "irregular/light_mesh.h"

#include <algorithm>
#include <array>
#include <span>

namespace firsthit {

/// The triangles that cover most of the samples' bounds.
struct CoverList {
    static constexpr int kMost = 16;
    std::array<SeenTriangle, kMost> triangle;
    int count = 0;

    std::span<const SeenTriangle> span() const { return {triangle.data(), std::size_t(count)}; }
};

/// Of the bounds, by the triangle's box.
inline double covered_area(const SeenTriangle& seen, const SampleBounds& bounds)
{
    const auto overlap = [](float low, float high, float from, float to) {
        return std::max(0.0, double(std::min(high, to)) - double(std::max(low, from)));
    };
    return overlap(seen.x0, seen.x1, bounds.x0, bounds.x1) *
           overlap(seen.y0, seen.y1, bounds.y0, bounds.y1);
}

/// Keeps the largest covers that it is offered.
class CoverChoice {
  public:
    static constexpr double kSmallest = 1.0 / 64; // of the bounds

    explicit CoverChoice(const SampleBounds& bounds) : bounds_(bounds)
    {
        least_ = kSmallest * (double(bounds.x1) - double(bounds.x0)) *
                 (double(bounds.y1) - double(bounds.y0));
    }

    void offer(const SeenTriangle& seen)
    {
        if (!(covered_area(seen, bounds_) > least_)) return;
        if (covers.count < CoverList::kMost) {
            covers.triangle[std::size_t(covers.count++)] = seen;
            return;
        }
        const auto area = [&](const SeenTriangle& s) { return covered_area(s, bounds_); };
        auto& smallest = *std::min_element(covers.triangle.begin(), covers.triangle.end(),
            [&](const auto& a, const auto& b) { return area(a) < area(b); });
        least_ = std::max(least_, area(smallest));
        if (area(seen) > area(smallest)) smallest = seen;
    }

    CoverList covers;

  private:
    SampleBounds bounds_;
    double least_;
};

} // namespace firsthit
