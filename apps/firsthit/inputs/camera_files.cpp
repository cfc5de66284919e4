// camera_files.cpp - cameras that come from files: --camera FILE, --camera-frame, --camera-path.
#include "inputs/camera_files.h"

#include "common/add_parsed.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace firsthit::cli {
namespace {

constexpr int kMostCameraFrames = 1'000'000;

/// throws  UsageError: an option that places the camera, or shapes its lens where `lens` is set
void check_alone(const CameraOptions& options, const char* name, bool lens)
{
    const char* other = options.eye                  ? "--eye"
                        : options.at                 ? "--at"
                        : options.up                 ? "--up"
                        : options.view               ? "--view"
                        : options.turntable > 0      ? "--turntable"
                        : options.fov_y_rad          ? "--fov"
                        : options.ortho              ? "--ortho"
                        : lens && options.intrinsics ? "--intrinsics"
                                                     : nullptr;
    if (other)
        throw UsageError(
            fmt::format("{} says where the camera is and how it sees; say it or {}", name, other));
}

} // namespace

void add_camera_file_options(CLI::App& app, CameraOptions& options)
{
    add_parsed(
        app, "--camera-frame", options.camera_frame,
        [](const std::string& text) { return parse_integer(text, 0, kMostCameraFrames); }, "N",
        "Of a camera's file with several: the one with this number, from 0; default a picture for "
        "each");
    add_parsed(app, "--region", options.region, parse_region, "x,y,w,h",
        "Render only these pixels, from the picture's top left; they are as in the whole picture");
    app.add_option("--camera-path", options.path_file,
           "A camera that moves: a file of keys with time, eye, target, up and fov, or matrices; "
           "without "
           "--frames it has pictures at its own rate")
        ->type_name("FILE.json");
}

void take_cameras(PoseOptions& pose, CameraOptions& options, std::vector<std::string>& files)
{
    if (is_camera_file(pose.camera)) {
        if (!options.path_file.empty())
            throw UsageError("--camera FILE and --camera-path both place the camera: say one");
        check_alone(options, "--camera FILE", false);
        options.cameras = read_cameras(pose.camera, options.pixel_center);
        std::error_code ignored;
        if (std::filesystem::is_regular_file(pose.camera, ignored)) files.push_back(pose.camera);
        const std::size_t count = options.cameras.size();
        if (options.camera_frame) {
            const auto number = static_cast<std::size_t>(*options.camera_frame);
            if (number >= count)
                throw UsageError(
                    fmt::format("--camera-frame: there is no camera {} in {}: accepted are 0 to {}",
                        number, pose.camera, count - 1));
            const FileCamera chosen = options.cameras[number];
            options.cameras = {chosen};
        }
        pose.camera.clear();
    } else if (options.camera_frame) {
        throw UsageError("--camera-frame is of a file with cameras: say --camera FILE too");
    }
    if (options.path_file.empty()) return;
    check_alone(options, "--camera-path", true);
    options.path = read_camera_path(options.path_file);
    files.push_back(options.path_file);
}

std::vector<double> path_times(const CameraPath& path)
{
    const double first = path.keys.front().time_s, last = path.keys.back().time_s;
    const double count = std::floor((last - first) * path.fps + 1e-6) + 1;
    if (count > kMostCameraFrames)
        throw UsageError(
            fmt::format("the path of the camera has {:.0f} pictures, at {} a second: accepted are "
                        "up to {}; --frames says other times",
                count, path.fps, kMostCameraFrames));
    std::vector<double> times;
    for (double k = 0; k < count; ++k) times.push_back(first + k / path.fps);
    return times;
}

} // namespace firsthit::cli
