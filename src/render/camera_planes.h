// camera_planes.h - planes in the camera's frame: normal_camera, position_camera.
#pragma once

#include "base/tasks.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

namespace firsthit {

/// Turns normals and depths into the camera's frame (x right, y down, z forward), after any engine has made
/// them.
class CameraPlanes {
  public:
    /// Takes these planes out of the settings, and puts in the normals and depths that they need.
    void without(Settings& own);

    /// Fills the planes that the last call of without() took away, and takes away what nobody asked for.
    ///
    /// view  with its region filled in
    void fill(const View& view, Tasks& tasks, Film& film) const;

  private:
    bool wants_normal_ = false;
    bool wants_position_ = false;
    bool had_normal_ = false;
    bool had_depth_ = false;
};

} // namespace firsthit
