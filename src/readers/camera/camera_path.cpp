// camera_path.cpp - a camera that moves: its keys from a file, and where it is at a time.
#include "io/whole_file.h"
#include "readers/camera/camera_pose.h"
#include "readers/camera/json_object.h"

#include <firsthit/camera_file.h>
#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFarthestEye = 1e30;

bool parallel_axes(const glm::dvec3& a, const glm::dvec3& b)
{
    const double reach = glm::length(a) * glm::length(b);
    return !(glm::length(glm::cross(a, b)) > 1e-9 * reach) || !std::isfinite(reach);
}

/// The turn from a camera that looks along -z, y up.
glm::dquat turn_of(const Camera& camera)
{
    const glm::dvec3 back = -glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
    return glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
}

glm::dvec3 vector_of(const JsonObject& json, const char* key)
{
    const std::vector<double> v = json.numbers(key, 1, 3);
    for (const double x : v)
        if (std::abs(x) > kFarthestEye)
            json.fail(key, fmt::format("{:g} is too far: up to 1e30", x));
    return {v[0], v[1], v[2]};
}

CameraKey read_key(const JsonObject& json, const CameraAxes axes)
{
    CameraKey key;
    key.time_s = json.number("time");
    const double fov_deg = json.number("fov", 45);
    if (!(fov_deg > 0 && fov_deg < 180))
        json.fail("fov", fmt::format("{:g} degrees: accepted are above 0 and below 180", fov_deg));
    key.fov_y_rad = fov_deg * kDegree;
    const bool matrix = json.has("camera_to_world") || json.has("world_to_camera");
    if (matrix == json.has("eye"))
        json.fail("eye",
            "accepted are eye, target and up, or one of camera_to_world and world_to_camera");
    if (!matrix) {
        key.eye = vector_of(json, "eye");
        key.target = vector_of(json, "target");
        if (json.has("up")) key.up = vector_of(json, "up");
        if (parallel_axes(*key.target - key.eye, key.up))
            json.fail("target", "eye and target coincide, or the camera looks along its up");
        return key;
    }
    const char* name = json.has("camera_to_world") ? "camera_to_world" : "world_to_camera";
    CameraPose pose = pose_of_camera_to_world(
        json.numbers(name, 4, 4), fmt::format("{}: {}", json.place(), name));
    if (json.has("world_to_camera")) pose = inverse(pose);
    Camera camera;
    place_camera(pose, axes, camera);
    key.eye = camera.eye;
    key.turn = turn_of(camera);
    return key;
}

/// Where the time lies: in the segment after key `at`, at a share of it.
struct PathPlace {
    std::size_t at;
    double share;
};

PathPlace place_of(const std::vector<CameraKey>& keys, double time_s)
{
    if (!(time_s > keys.front().time_s)) return {0, 0};
    if (time_s >= keys.back().time_s) return {keys.size() - 1, 0};
    std::size_t at = 0;
    while (keys[at + 1].time_s <= time_s) ++at;
    return {at, (time_s - keys[at].time_s) / (keys[at + 1].time_s - keys[at].time_s)};
}

/// The value of what `get` gives, at a place between keys.
template <class Get>
auto between(const CameraPath& path, const PathPlace& place, const Get& get)
{
    const std::vector<CameraKey>& keys = path.keys;
    const auto a = get(keys[place.at]);
    if (place.share == 0) return a;
    const auto b = get(keys[place.at + 1]);
    const double s = place.share;
    if (!path.smooth) return a * (1 - s) + b * s;
    const double length = keys[place.at + 1].time_s - keys[place.at].time_s;
    // Slopes by time; at both ends of the path that of its first or last segment.
    const auto slope = [&](std::size_t k) {
        const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, keys.size() - 1);
        return (get(keys[after]) - get(keys[before])) *
               (length / (keys[after].time_s - keys[before].time_s));
    };
    const double s2 = s * s, s3 = s2 * s;
    return a * (2 * s3 - 3 * s2 + 1) + slope(place.at) * (s3 - 2 * s2 + s) + b * (3 * s2 - 2 * s3) +
           slope(place.at + 1) * (s3 - s2);
}

} // namespace

CameraPath read_camera_path(const std::string& path)
{
    const gltf::Json json = gltf::parse_json(
        read_whole_file(path, std::uintmax_t(1) << 30), path, "a path of a camera");
    const JsonObject whole(json, path);
    CameraPath made;
    const std::string how = whole.text("interpolation", "linear");
    if (how != "linear" && how != "smooth")
        whole.fail("interpolation", "accepted are linear and smooth");
    made.smooth = how == "smooth";
    made.fps = whole.number("fps", made.fps);
    if (!(made.fps >= 1e-3 && made.fps <= 1e4)) whole.fail("fps", "accepted are 0.001 to 10000");
    const CameraAxes axes =
        axes_from_name(whole.text("convention", "opencv"), path + ": convention");
    const gltf::Json& keys = whole.array("keys");
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const JsonObject key(keys[k], fmt::format("{}: keys[{}]", path, k));
        made.keys.push_back(read_key(key, axes));
        if (k > 0 && !(made.keys[k].time_s > made.keys[k - 1].time_s))
            key.fail("time", "is not above that of the key before");
        if (made.keys[k].target.has_value() != made.keys[0].target.has_value())
            key.fail(
                "eye", "some keys have a target and some a matrix: accepted is one way for all");
    }
    return made;
}

Camera camera_at(const CameraPath& path, double time_s)
{
    if (path.keys.empty()) throw ArgumentError("the path of the camera has no key");
    const PathPlace place = place_of(path.keys, time_s);
    Camera camera;
    camera.eye = between(path, place, [](const CameraKey& key) { return key.eye; });
    camera.fov_y_rad =
        std::clamp(between(path, place, [](const CameraKey& key) { return key.fov_y_rad; }), 1e-6,
            std::numbers::pi - 1e-6);
    const CameraKey& key = path.keys[place.at];
    if (key.target) {
        const glm::dvec3 target =
            between(path, place, [](const CameraKey& k) { return k.target.value_or(k.eye); });
        const glm::dvec3 up = between(path, place, [](const CameraKey& k) { return k.up; });
        camera.direction = target - camera.eye;
        camera.up = up;
        // Between two keys a straight line may lead where there is no direction.
        if (parallel_axes(camera.direction, camera.up)) {
            camera.direction = *key.target - key.eye;
            camera.up = key.up;
        }
        return camera;
    }
    glm::dquat turn = key.turn;
    if (place.share > 0) turn = glm::slerp(turn, path.keys[place.at + 1].turn, place.share);
    camera.direction = turn * glm::dvec3(0, 0, -1);
    camera.up = turn * glm::dvec3(0, 1, 0);
    return camera;
}

} // namespace firsthit
