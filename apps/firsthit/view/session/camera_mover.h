// camera_mover.h - moves a camera as a hand asks: round a point, sideways, towards the pointer, through the scene.
#pragma once

#include "view/frames/box.h"

#include <firsthit/view.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <string>

namespace firsthit::cli::view {

/// A pinhole or orthographic camera with the point that it turns about. What it shows is what `render` shows with the options
/// that as_options() writes, bit for bit.
class CameraMover {
  public:
    /// Takes a camera over. The point in its middle is as far as the middle of the box is along its axis, so
    /// that turning keeps the scene in the picture.
    /// up_axis  what stays upright while the camera turns
    /// height   pixels of its picture, of which the lens of a calibrated camera is
    void take(const Camera& camera, const Box& box, const glm::dvec3& up_axis, int height);

    /// Puts the point in the middle at a distance, where the eye is inside of the box, as in a landscape: its middle is
    /// of no use then.
    void focus(double distance, const Box& box);

    /// Turns about the point in the middle: about the upright axis, and up and down as far as the poles.
    void orbit(double right_rad, double up_rad);
    /// Turns about the eye.
    void look(double right_rad, double up_rad);
    /// Moves sideways. moved  as a share of the picture's height, right and down
    void pan(const glm::dvec2& moved);
    /// Comes nearer by a factor below 1, or goes away; what is under the pointer stays there. The picture of an
    /// orthographic camera gets smaller or larger by it too.
    /// pointer  from the picture's middle, as a share of its height, right and down
    void zoom(double factor, const glm::dvec2& pointer);
    /// Flies along its axes, in units of the distance to the point in the middle. x right, y up, z forward
    void fly(const glm::dvec3& moved);

    /// Shows a box from a direction. aspect  the picture's width by its height
    void frame(const Box& box, const glm::dvec3& towards_eye, const glm::dvec3& up, double aspect);
    /// Shows a box from where it looks now.
    void frame(const Box& box, double aspect);

    Camera camera() const;
    double distance() const;

    /// "--eye x,y,z --at x,y,z --up x,y,z --fov DEG", with all digits; or --ortho HEIGHT.
    std::string as_options() const;

  private:
    /// Right, up and forward of the picture, unit.
    std::array<glm::dvec3, 3> axes() const;
    /// Turns a vector from the eye or to it.
    glm::dvec3 turned(const glm::dvec3& v, double right_rad, double up_rad) const;
    /// The height of the picture at the point in the middle, world units.
    double height() const;

    glm::dvec3 eye_{0, 0, 3};
    glm::dvec3 at_{0};
    glm::dvec3 up_{0, 1, 0};
    double fov_deg_ = 45;
    double ortho_height_ = 0; // of an orthographic camera; 0: a pinhole camera
};

} // namespace firsthit::cli::view
