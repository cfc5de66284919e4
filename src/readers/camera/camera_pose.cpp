// camera_pose.cpp - a camera's place from the matrices that files have.
#include "readers/camera/camera_pose.h"

#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Matrices of files are often rounded to four digits.
constexpr double kOrthonormal = 1e-3;

constexpr double kFarthestShift = 1e30;

} // namespace

glm::dmat3 checked_rotation(std::span<const double> rows, const std::string& place)
{
    const glm::dvec3 x(rows[0], rows[1], rows[2]), y(rows[3], rows[4], rows[5]),
        z(rows[6], rows[7], rows[8]);
    const double off = std::max(
        {std::abs(glm::length(x) - 1), std::abs(glm::length(y) - 1), std::abs(glm::length(z) - 1),
            std::abs(glm::dot(x, y)), std::abs(glm::dot(y, z)), std::abs(glm::dot(z, x))});
    if (!(off <= kOrthonormal))
        throw FileError(
            fmt::format("{}: no rotation: its rows are unit and perpendicular only to {:.2g}; "
                        "accepted is {:g}, without scale or shear",
                place, off, kOrthonormal));
    if (glm::dot(glm::cross(x, y), z) < 0)
        throw FileError(
            fmt::format("{}: left-handed: its determinant is -1, that of a mirror; accepted "
                        "is 1",
                place));
    // Gram and Schmidt, from the viewing axis on.
    const glm::dvec3 unit_z = glm::normalize(z);
    const glm::dvec3 unit_x = glm::normalize(x - glm::dot(x, unit_z) * unit_z);
    return glm::transpose(glm::dmat3(unit_x, glm::cross(unit_z, unit_x), unit_z));
}

glm::dvec3 checked_shift(const glm::dvec3& shift, const std::string& place)
{
    for (int c = 0; c < 3; ++c)
        if (!(std::abs(shift[c]) <= kFarthestShift))
            throw FileError(
                fmt::format("{}: the translation {:g} is too far: accepted is up to {:g}", place,
                    shift[c], kFarthestShift));
    return shift;
}

CameraPose pose_of_camera_to_world(std::span<const double> rows, const std::string& place)
{
    if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1)
        throw FileError(
            fmt::format("{}: its last row is {:g}, {:g}, {:g}, {:g}; accepted is 0, 0, 0, 1", place,
                rows[12], rows[13], rows[14], rows[15]));
    const double turn[] = {
        rows[0], rows[1], rows[2], rows[4], rows[5], rows[6], rows[8], rows[9], rows[10]};
    return {checked_rotation(turn, place), checked_shift({rows[3], rows[7], rows[11]}, place)};
}

CameraPose inverse(const CameraPose& pose)
{
    const glm::dmat3 back = glm::transpose(pose.axes);
    return {back, -(back * pose.eye)};
}

void place_camera(const CameraPose& pose, CameraAxes axes, Camera& camera)
{
    const double sign = axes == CameraAxes::opencv ? 1 : -1;
    camera.eye = pose.eye;
    camera.direction = sign * pose.axes[2];
    camera.up = -sign * pose.axes[1];
}

CameraAxes axes_from_name(std::string_view name, const std::string& place)
{
    if (name == "opencv") return CameraAxes::opencv;
    if (name == "opengl" || name == "blender") return CameraAxes::opengl;
    throw FileError(
        fmt::format("{}: '{}' is no convention: accepted are opencv (x right, y down, z forward), "
                    "opengl and blender (x right, y up, z backward)",
            place, printable(name)));
}

} // namespace firsthit
