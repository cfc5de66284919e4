// camera_options.cpp - which eye looks at the scene, and at how many pixels.
#include "options/camera_options.h"

#include "common/usage.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace firsthit::cli {

namespace {

bool parallel(const glm::dvec3& a, const glm::dvec3& b)
{
    const double sine = glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
    return !(sine > 1e-9);
}

} // namespace

void add_camera_options(CLI::App& app, CameraOptions& options)
{
    add_parsed(app, "--size", options.size, parse_size, "WxH",
        "Pixels, each side 1 to 65536; default 1024x1024");
    add_parsed(app, "--eye", options.eye, parse_vector, "x,y,z",
        "Where the eye is. Without --at, the scene's own camera moves without turning; a scene "
        "without a camera is looked at in its middle");
    add_parsed(app, "--at", options.at, parse_vector, "x,y,z", "A point that the eye looks at");
    add_parsed(app, "--up", options.up, parse_vector, "x,y,z",
        "What is up in the picture; default the camera's, or 0,0,-1 when it looks along that");
    add_parsed(app, "--fov", options.fov_y_rad, parse_fov, "DEG",
        "Full vertical angle, above 0 and below 180");
}

Camera override_camera(
    const Camera& camera, const CameraOptions& options, const std::optional<glm::dvec3>& middle)
{
    Camera result = camera;
    if (options.eye) result.eye = *options.eye;
    if (options.at)
        result.direction = *options.at - result.eye;
    else if (options.eye && middle)
        result.direction = *middle - result.eye;
    if (result.direction == glm::dvec3(0))
        throw UsageError("the eye and the point that it looks at coincide: move --eye or --at");
    if (options.up) result.up = *options.up;
    if (options.up && (result.up == glm::dvec3(0) || parallel(result.direction, result.up)))
        throw UsageError("--up is parallel to the direction of view: choose another");
    const bool turned = options.eye || options.at;
    if (!options.up && turned && parallel(result.direction, result.up)) result.up = {0, 0, -1};
    if (options.fov_y_rad) {
        result.fov_y_rad = *options.fov_y_rad;
        result.focal.reset();
    }
    return result;
}

View ViewMaker::view(const World& world)
{
    const bool own = world.scene->camera || world.scene->camera_track >= 0;
    if (!own && !framing_) {
        framing_ = framing_camera(world);
        const std::array<glm::vec3, 2> box = bounds(world);
        middle_ = (glm::dvec3(box[0]) + glm::dvec3(box[1])) * 0.5;
    }
    View view;
    view.camera = override_camera(own ? world.camera : *framing_, options_, middle_);
    view.width = options_.size.width;
    view.height = options_.size.height;
    return view;
}

} // namespace firsthit::cli
