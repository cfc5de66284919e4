// camera_options.h - which eye looks at the scene, and at how many pixels.
#pragma once

#include "common/parse.h"

#include <firsthit/camera_file.h>
#include <firsthit/framing.h>
#include <firsthit/view.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct CameraOptions {
    std::optional<Size> size; // absent: the file's, or the default
    Size file_size;           // what the scene's file asks for; see take_size
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> at;
    std::optional<glm::dvec3> up;
    std::optional<double> fov_y_rad;
    std::optional<double> ortho;   // height of an orthographic picture, world units; 0: as it fits
    std::optional<NamedView> view; // none: the scene's camera, or iso where it has none
    std::optional<glm::dvec3> up_axis; // of named views and turntables; none: by the kind of file
    double zoom = 1;                   // how many times as large things are in the picture
    int turntable = 0;                 // pictures of one turn around the scene; 0: no turntable

    std::optional<std::array<double, 5>>
        intrinsics;                     // fx, fy, cx, cy, skew in pixels, as they were given
    std::optional<double> pixel_center; // of intrinsics and files: 0 or 0.5
    std::optional<int> camera_frame;    // of a file with several cameras
    std::string path_file;              // of --camera-path
    Region region;                      // of the picture that is rendered

    std::vector<FileCamera> cameras; // of the file of --camera: see take_cameras
    std::optional<CameraPath> path;  // of --camera-path, likewise

    /// The picture's size in pixels, the first one's where cameras of a file differ.
    Size pixels() const { return pixels(0); }
    /// The size of one picture.
    Size pixels(std::size_t number) const;
    /// Which camera of the file a picture has.
    const FileCamera& camera(std::size_t number) const
    {
        return cameras[std::min(number, cameras.size() - 1)];
    }
};

/// The axis that points up in files of a kind, by the name's ending: z in .stl, .ply and .3mf, else y.
glm::dvec3 usual_up_axis(const std::string& scene);

/// "iso", "front", "back", "left", "right", "top" or "bottom". throws  UsageError
NamedView parse_view(const std::string& text);

/// "x", "y", "z", "-x", "-y" or "-z". throws  UsageError
glm::dvec3 parse_axis(const std::string& text);

/// "fx,fy,cx,cy" or "fx,fy,cx,cy,skew". throws  UsageError
std::array<double, 5> parse_intrinsics(const std::string& text);

/// "x,y,w,h" in pixels. throws  UsageError
Region parse_region(const std::string& text);

/// --size, --view, --zoom, --up-axis, --eye, --at, --up, --fov, --ortho, --intrinsics, --pixel-center
void add_camera_options(CLI::App& app, CameraOptions& options);

/// Takes the size that the scene's file asks for as the default of --size.
void take_size(const Scene& scene, CameraOptions& options);

/// A camera with parts replaced. --eye alone moves it: towards `middle` where that is given (a
/// scene without a camera of its own), else without turning. --at turns it. Where `up` was not
/// given and the camera looks along it, -z becomes up: the top of a plan. throws  UsageError: eye
/// and at coincide, or the direction and the --up given are parallel. --ortho makes the camera orthographic;
/// where its height is to fit, `middle` is as large as it was
Camera override_camera(
    const Camera& camera, const CameraOptions& options, const std::optional<glm::dvec3>& middle);

/// Makes the views of a scene's frames. Where a scene has no camera, or --view was given, the camera frames
/// the first world that it is asked for, and is kept.
class ViewMaker {
  public:
    /// scene  its name
    ViewMaker(const CameraOptions& options, const std::string& scene)
        : options_(options),
          up_axis_(options.up_axis.value_or(usual_up_axis(scene)))
    {
    }

    /// Also takes the world's lights that go with the camera along.
    /// number  of the picture, which says how far the turntable is turned
    /// throws  as override_camera
    View view(World& world, std::size_t number = 0);

  private:
    void frame(const World& world);

    CameraOptions options_;
    glm::dvec3 up_axis_;
    std::optional<Camera> framing_;
    std::optional<glm::dvec3> middle_;
};

} // namespace firsthit::cli
