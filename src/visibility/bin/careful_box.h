// careful_box.h - the samples of a triangle that reaches behind the eye.
#pragma once

#include "exact/hit.h"
#include "visibility/bin/view_memory.h"

#include <limits>
#include <optional>

namespace firsthit {

/// The projections x/z (axis 0) or y/z (axis 1) of what a triangle has in front of the eye, z > 0.
/// Infinite where the triangle reaches behind the eye on that side; low > high: nothing in front.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};
Interval project_front(const Corners& corners, int axis);

/// A box that holds every sample hit by the triangle, or nothing where no sample can be hit.
std::optional<InView> careful_box(
    std::uint32_t triangle, const Corners& corners, const Pencil& pencil);

} // namespace firsthit
