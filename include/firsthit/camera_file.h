// camera_file.h - calibrated cameras and camera paths from files.
#pragma once

#include <firsthit/view.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace firsthit {

/// A camera of a file.
struct FileCamera {
    std::string name;       // of its picture, or empty
    Camera camera{};        // its lens is of pixels of width x height
    int width = 0;          // pixels; 0: the file does not say, and camera.fov_y_rad is unused
    int height = 0;         // pixels; 0 as width
    double angle_x_rad = 0; // full horizontal angle, of a camera without a size; else 0
};

/// Whether a name is that of a file or folder with cameras: it ends in .json, cameras.txt or images.txt, or is
/// a folder.
bool is_camera_file(const std::string& name);

/// Reads the cameras of a file, in its order. docs/cameras.md has the formats:
/// - .json with K, width, height, and a pose by world_to_camera, camera_to_world, or R and t, whose axes
///   `convention` names; or an array of such
/// - transforms.json of NeRF datasets
/// - a folder of COLMAP's text files, cameras.txt and images.txt
///
/// pixel_center  where pixel (0, 0) has its centre in the file's pixels, 0 or 0.5, in the place of what the
///               file or its format says
/// throws  FileError: unreadable; no cameras; distortion that is not 0; a matrix that is no rotation, or
///         left-handed; names the file and the place
///         ArgumentError: a pixel_center that is neither
std::vector<FileCamera> read_cameras(
    const std::string& path, const std::optional<double>& pixel_center = {});

/// The camera for a picture of another size: the lens is scaled with it, on each axis.
/// throws  ArgumentError: a size below 1
Camera resized_camera(const FileCamera& camera, int width, int height);

/// A camera at a time.
struct CameraKey {
    double time_s = 0;                  // above that of the key before
    glm::dvec3 eye{0};                  // world space
    std::optional<glm::dvec3> target{}; // what it looks at; of all keys or of none
    glm::dvec3 up{0, 1, 0};             // of keys with a target
    glm::dquat turn{1, 0, 0, 0};        // of keys without: from a camera that looks along -z, y up
    double fov_y_rad = 0.78539816339744831; // full vertical angle
};

/// A camera that moves.
struct CameraPath {
    std::vector<CameraKey> keys; // at least one
    bool smooth = false;         // through the keys by cubic curves, else by straight lines
    double fps = 25;             // pictures a second that the file asks for
};

/// Reads a path: docs/cameras.md has the format.
/// throws  FileError: names the file and the place
CameraPath read_camera_path(const std::string& path);

/// The camera at a time; before the first key the first, after the last the last. Eyes, targets, ups and angles
/// are interpolated, linearly or by the cubic Hermite curve whose slope at a key is that between its
/// neighbours (Catmull and Rom 1974); turns on the shortest way (Shoemake 1985).
/// throws  ArgumentError: no key
Camera camera_at(const CameraPath& path, double time_s);

} // namespace firsthit
