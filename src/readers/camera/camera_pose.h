// camera_pose.h - a camera's place from the matrices that files have.
#pragma once

#include <firsthit/view.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <string_view>

namespace firsthit {

/// What the axes of a camera's frame are.
enum class CameraAxes {
    opencv, // x right, y down, z forward: OpenCV, COLMAP
    opengl, // x right, y up, z backward: OpenGL, Blender, NeRF
};

/// Where a camera is: its axes, as columns, and its eye in world space.
struct CameraPose {
    glm::dmat3 axes{1};
    glm::dvec3 eye{0};
};

/// A rotation of 9 numbers, row by row, made exactly orthonormal.
/// place   stands in messages, as "a.json: R"
/// throws  FileError: rows that are not unit and perpendicular to a thousandth, or left-handed
glm::dmat3 checked_rotation(std::span<const double> rows, const std::string& place);

/// A translation. throws  FileError: a coordinate beyond 1e30
glm::dvec3 checked_shift(const glm::dvec3& shift, const std::string& place);

/// The 4 x 4 matrix, row by row, from a camera's frame to the world.
/// throws  as checked_rotation; FileError: a last row other than 0, 0, 0, 1
CameraPose pose_of_camera_to_world(std::span<const double> rows, const std::string& place);

/// The pose of which that is the inverse.
CameraPose inverse(const CameraPose& pose);

/// Gives the camera its eye, direction and up.
void place_camera(const CameraPose& pose, CameraAxes axes, Camera& camera);

/// "opencv", "opengl" or "blender". throws  FileError
CameraAxes axes_from_name(std::string_view name, const std::string& place);

} // namespace firsthit
