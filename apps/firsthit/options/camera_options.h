// camera_options.h - which eye looks at the scene, and at how many pixels.
#pragma once

#include "common/parse.h"

#include <firsthit/scene.h>
#include <firsthit/view.h>

#include <CLI/CLI.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace firsthit::cli {

struct CameraOptions {
    Size size;
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> at;
    std::optional<glm::dvec3> up;
    std::optional<double> fov_y_rad;
};

/// --size, --eye, --at, --up, --fov
void add_camera_options(CLI::App& app, CameraOptions& options);

/// A camera with parts replaced. --eye alone moves it: towards `middle` where that is given (a
/// scene without a camera of its own), else without turning. --at turns it. Where `up` was not
/// given and the camera looks along it, -z becomes up: the top of a plan. throws  UsageError: eye
/// and at coincide, or the direction and the --up given are parallel
Camera override_camera(
    const Camera& camera, const CameraOptions& options, const std::optional<glm::dvec3>& middle);

/// Makes the views of a scene's frames: a scene without a camera gets one that frames the first
/// world it is asked for, and keeps it.
class ViewMaker {
  public:
    explicit ViewMaker(const CameraOptions& options) : options_(options) {}

    /// throws  as override_camera
    View view(const World& world);

  private:
    CameraOptions options_;
    std::optional<Camera> framing_;
    std::optional<glm::dvec3> middle_;
};

} // namespace firsthit::cli
