// camera_lens.cpp - a camera's intrinsics from the numbers that files have.
#include "readers/camera/camera_lens.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>

namespace firsthit {
namespace {

// The ranges of view.h.
constexpr double kLeastFocal = 1e-12, kMostFocal = 1e15;
constexpr double kFarthestCenter = 131072;
constexpr double kMostSkew = 1000; // times fx

} // namespace

void set_lens(const CameraLens& lens, double pixel_center, const std::string& place, Camera& camera)
{
    const auto focal = [](double f) { return kLeastFocal <= f && f <= kMostFocal; };
    if (!focal(lens.fx) || !focal(lens.fy))
        throw FileError(
            fmt::format("{}: focal lengths {:g} and {:g} pixels: accepted are {:g} to {:g}", place,
                lens.fx, lens.fy, kLeastFocal, kMostFocal));
    const double cx = lens.cx + (0.5 - pixel_center), cy = lens.cy + (0.5 - pixel_center);
    if (!(std::abs(cx) <= kFarthestCenter && std::abs(cy) <= kFarthestCenter))
        throw FileError(
            fmt::format("{}: principal point ({:g}, {:g}): accepted are -{} to {} pixels", place,
                lens.cx, lens.cy, kFarthestCenter, kFarthestCenter));
    if (!(std::abs(lens.skew) <= kMostSkew * lens.fx))
        throw FileError(
            fmt::format("{}: skew {:g} pixels: accepted are up to {} times the focal length", place,
                lens.skew, kMostSkew));
    camera.focal = {lens.fx, lens.fy};
    camera.principal_point = {cx, cy};
    camera.skew = lens.skew;
}

void check_undistorted(std::span<const double> coefficients, const std::string& place)
{
    for (const double coefficient : coefficients)
        if (coefficient != 0)
            throw FileError(
                fmt::format("{}: a coefficient of distortion is {:g}: accepted is 0; lenses that "
                            "bend lines are not drawn: undistort the pictures and take the camera "
                            "of those",
                    place, coefficient));
}

} // namespace firsthit
