// careful_box.h - the box of samples of a triangle that reaches behind the eye.
#pragma once

#include "exact/hit.h"
#include "exact/pencil.h"
#include "visibility/bin/bins.h"

#include <limits>
#include <optional>

namespace firsthit {

/// The projections x/z or y/z of the part of a triangle that is in front of the eye, z > 0. A bound
/// is infinite where the triangle reaches behind the eye on that side. low > high if no part is in
/// front.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// axis  0 for x/z, 1 for y/z
Interval project_front(const Corners& corners, int axis);

/// A box that holds every sample whose ray hits the triangle, or nothing if no sample can hit it.
///
/// triangle  its id, which is copied to the result
/// corners   in eye space
std::optional<InView> careful_box(
    std::uint32_t triangle, const Corners& corners, const Pencil& pencil);

} // namespace firsthit
