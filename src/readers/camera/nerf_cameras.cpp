// nerf_cameras.cpp - transforms.json of NeRF datasets: a lens, and a matrix for each picture.
#include "readers/camera/camera_lens.h"
#include "readers/camera/camera_pose.h"
#include "readers/camera/json_object.h"
#include "readers/camera/read_camera_json.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr int kMostPixels = 65536;

/// A key that a frame may have of its own, else the whole file.
class Lookup {
  public:
    Lookup(const JsonObject& file, const JsonObject& frame) : file_(file), frame_(frame) {}

    bool has(const char* key) const { return frame_.has(key) || file_.has(key); }
    double number(const char* key) const { return who(key).number(key); }
    double number(const char* key, double fallback) const
    {
        return has(key) ? number(key) : fallback;
    }
    int integer(const char* key) const { return who(key).integer(key, 1, kMostPixels); }
    const JsonObject& who(const char* key) const { return frame_.has(key) ? frame_ : file_; }

  private:
    const JsonObject& file_;
    const JsonObject& frame_;
};

double angle_of(const Lookup& lookup, const char* key)
{
    const double angle = lookup.number(key);
    if (!(angle > 0 && angle < std::numbers::pi))
        lookup.who(key).fail(
            key, fmt::format("{:g} rad: accepted are above 0 and below pi", angle));
    return angle;
}

void set_nerf_lens(const Lookup& lookup, double pixel_center, FileCamera& made)
{
    for (const char* key : {"k1", "k2", "k3", "k4", "p1", "p2"}) {
        const double value = lookup.number(key, 0);
        check_undistorted({&value, 1}, fmt::format("{}: {}", lookup.who(key).place(), key));
    }
    if (lookup.has("w") != lookup.has("h"))
        lookup.who("w").fail("w", "w and h go together, and one is missing");
    if (lookup.has("w")) {
        made.width = lookup.integer("w");
        made.height = lookup.integer("h");
    }
    if (lookup.has("fl_x")) {
        const double width = made.width, height = made.height;
        if (made.width == 0)
            lookup.who("fl_x").fail("fl_x", "is in pixels of a picture whose w and h are missing");
        CameraLens lens{.fx = lookup.number("fl_x")};
        lens.fy = lookup.number("fl_y", lens.fx);
        // Without them the middle, wherever centres of pixels are.
        lens.cx = lookup.number("cx", 0.5 * width - 0.5 + pixel_center);
        lens.cy = lookup.number("cy", 0.5 * height - 0.5 + pixel_center);
        return set_lens(lens, pixel_center, lookup.who("fl_x").place(), made.camera);
    }
    if (!lookup.has("camera_angle_x"))
        lookup.who("fl_x").fail(
            "camera_angle_x", "is missing, and so is fl_x: one of them says the lens");
    const double angle_x = angle_of(lookup, "camera_angle_x");
    if (made.width == 0) {
        made.angle_x_rad = angle_x;
        return;
    }
    CameraLens lens{.fx = 0.5 * made.width / std::tan(0.5 * angle_x)};
    lens.fy = lookup.has("camera_angle_y")
                  ? 0.5 * made.height / std::tan(0.5 * angle_of(lookup, "camera_angle_y"))
                  : lens.fx;
    lens.cx = lookup.number("cx", 0.5 * made.width - 0.5 + pixel_center);
    lens.cy = lookup.number("cy", 0.5 * made.height - 0.5 + pixel_center);
    set_lens(lens, pixel_center, lookup.who("camera_angle_x").place(), made.camera);
}

} // namespace

std::vector<FileCamera> read_nerf_cameras(
    const gltf::Json& json, const std::string& file, const std::optional<double>& pixel_center)
{
    const JsonObject whole(json, file);
    const std::string model = whole.text("camera_model", "PINHOLE");
    if (model != "PINHOLE" && model != "OPENCV" && model != "SIMPLE_PINHOLE")
        whole.fail(
            "camera_model", fmt::format("'{}': accepted are PINHOLE, SIMPLE_PINHOLE, and OPENCV "
                                        "without distortion",
                                model));
    if (json.contains("is_fisheye") && json["is_fisheye"] != false)
        whole.fail("is_fisheye", "accepted is false: lenses that bend lines are not drawn");
    std::vector<FileCamera> cameras;
    const gltf::Json& frames = whole.array("frames");
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const JsonObject frame(frames[k], fmt::format("{}: frames[{}]", file, k));
        FileCamera made;
        made.name = frame.text("file_path", "");
        set_nerf_lens(Lookup(whole, frame), pixel_center.value_or(0.5), made);
        const CameraPose pose = pose_of_camera_to_world(frame.numbers("transform_matrix", 4, 4),
            fmt::format("{}: transform_matrix", frame.place()));
        place_camera(pose, CameraAxes::opengl, made.camera);
        cameras.push_back(made);
    }
    return cameras;
}

} // namespace firsthit
