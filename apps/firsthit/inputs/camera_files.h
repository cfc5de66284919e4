// camera_files.h - cameras that come from files: --camera FILE, --camera-frame, --camera-path.
#pragma once

#include "options/camera_options.h"
#include "options/pose_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// --camera-frame, --camera-path, --region
void add_camera_file_options(CLI::App& app, CameraOptions& options);

/// Where --camera names a file, reads its cameras in the place of the scene's camera; and the path of --camera-path.
/// Files that were read are added to `files`.
/// throws  UsageError: both, other options that place the camera, a number of --camera-frame that there is not
///         FileError: as read_cameras and read_camera_path
void take_cameras(PoseOptions& pose, CameraOptions& options, std::vector<std::string>& files);

/// The times of a path's own pictures, at the number a second that it asks for.
/// throws  UsageError: more than a million
std::vector<double> path_times(const CameraPath& path);

} // namespace firsthit::cli
