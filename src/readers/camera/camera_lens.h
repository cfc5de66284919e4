// camera_lens.h - a camera's intrinsics from the numbers that files have.
#pragma once

#include <firsthit/view.h>

#include <span>
#include <string>

namespace firsthit {

/// Intrinsics in pixels.
struct CameraLens {
    double fx = 0, fy = 0, cx = 0, cy = 0, skew = 0;
};

/// Gives the camera its lens.
///
/// pixel_center  where pixel (0, 0) has its centre: 0 or 0.5
/// place         stands in messages
/// throws        FileError: focal lengths that are not above 0, or numbers out of a view's range
void set_lens(
    const CameraLens& lens, double pixel_center, const std::string& place, Camera& camera);

/// throws  FileError: a coefficient that is not 0
void check_undistorted(std::span<const double> coefficients, const std::string& place);

} // namespace firsthit
