// calibrated_camera.cpp - cameras from JSON with K, a size, and a pose.
#include "readers/camera/camera_lens.h"
#include "readers/camera/camera_pose.h"
#include "readers/camera/json_object.h"
#include "readers/camera/read_camera_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace firsthit {
namespace {

constexpr int kMostPixels = 65536;

CameraLens lens_of(const JsonObject& json)
{
    const std::vector<double> k = json.numbers("K", 3, 3);
    const bool form = k[3] == 0 && k[6] == 0 && k[7] == 0 && k[8] == 1;
    if (!form) json.fail("K", "accepted is [[fx, skew, cx], [0, fy, cy], [0, 0, 1]]");
    return {.fx = k[0], .fy = k[4], .cx = k[2], .cy = k[5], .skew = k[1]};
}

/// The pose of camera to world. One of three ways says it.
CameraPose pose_of(const JsonObject& json)
{
    const bool to_camera = json.has("world_to_camera"), to_world = json.has("camera_to_world"),
               parts = json.has("R") || json.has("t");
    if (int(to_camera) + int(to_world) + int(parts) != 1)
        json.fail("pose",
            "accepted is one of world_to_camera (4 x 4), camera_to_world (4 x 4), and R (3 x 3) "
            "with t (3), from the world to the camera");
    const auto place = [&](const char* key) { return fmt::format("{}: {}", json.place(), key); };
    if (to_world)
        return pose_of_camera_to_world(
            json.numbers("camera_to_world", 4, 4), place("camera_to_world"));
    if (to_camera)
        return inverse(pose_of_camera_to_world(
            json.numbers("world_to_camera", 4, 4), place("world_to_camera")));
    const std::vector<double> t = json.numbers("t", 1, 3);
    return inverse({checked_rotation(json.numbers("R", 3, 3), place("R")),
        checked_shift({t[0], t[1], t[2]}, place("t"))});
}

/// Where pixel (0, 0) has its centre.
double center_of(const JsonObject& json, CameraAxes axes, const std::optional<double>& asked)
{
    const double usual = axes == CameraAxes::opencv ? 0.0 : 0.5;
    const double of_file = json.number("pixel_center", usual);
    if (of_file != 0 && of_file != 0.5)
        json.fail("pixel_center", fmt::format("{:g}: accepted are 0 and 0.5", of_file));
    return asked.value_or(of_file);
}

FileCamera calibrated_camera(const JsonObject& json, const std::optional<double>& pixel_center)
{
    FileCamera made;
    made.name = json.text("name", "");
    made.width = json.integer("width", 1, kMostPixels);
    made.height = json.integer("height", 1, kMostPixels);
    if (!json.has("convention"))
        json.fail("convention",
            "is missing: accepted are opencv (x right, y down, z forward), opengl and "
            "blender (x right, y up, z backward)");
    const CameraAxes axes =
        axes_from_name(json.text("convention", ""), fmt::format("{}: convention", json.place()));
    for (const char* key : {"distortion", "dist_coeffs"})
        check_undistorted(json.list(key), fmt::format("{}: {}", json.place(), key));
    set_lens(lens_of(json), center_of(json, axes, pixel_center), fmt::format("{}: K", json.place()),
        made.camera);
    place_camera(pose_of(json), axes, made.camera);
    return made;
}

} // namespace

std::vector<FileCamera> read_calibrated_cameras(
    const gltf::Json& json, const std::string& file, const std::optional<double>& pixel_center)
{
    if (!json.is_array()) return {calibrated_camera(JsonObject(json, file), pixel_center)};
    std::vector<FileCamera> cameras;
    for (std::size_t k = 0; k < json.size(); ++k)
        cameras.push_back(
            calibrated_camera(JsonObject(json[k], fmt::format("{}: [{}]", file, k)), pixel_center));
    return cameras;
}

} // namespace firsthit
