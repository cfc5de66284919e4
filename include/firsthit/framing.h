// framing.h - cameras that show a whole world.
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

namespace firsthit {

/// From where a world is shown.
struct Framing {
    glm::dvec3 towards_eye{0, 0.3, 1};      // from the world to the eye, any length but 0
    glm::dvec3 up{0, 1, 0};                 // up in the picture, not parallel to towards_eye
    double aspect = 1;                      // the picture's width by its height, above 0
    double fov_y_rad = 0.78539816339744831; // full vertical angle, in (0, pi)
    bool all_around =
        false; // the eye looks at the middle of the bounding box, and all stays in the
               // picture when it goes round it
    bool orthographic =
        false;            // parallel rays: fov_y_rad is unused, and the picture's height is found
    double margin = 0.05; // of the picture's half width or height that stays free, 0 to 0.9
};

/// The camera that looks along -towards_eye from as near as possible, so that all vertices are in the
/// picture. Unless `all_around` is set, they reach its margin at two opposite sides and lie in the middle
/// between the others; but the eye stays a twentieth of the bounding box's diagonal off the nearest vertex. A
/// world without extent is seen from some way off. The eye of an orthographic camera is before all vertices.
Camera framing_camera(const World& world, const Framing& framing);

/// Usual directions to look from.
enum class NamedView { iso, front, back, left, right, top, bottom };

/// The framing of a view of a world whose upward axis is `up`. The front is seen from +z where y or x is up,
/// and from -y where z is up, so that x points to the right. `iso` shows front, right side and top: 35
/// degrees from the front and 25 degrees above. Seen from the top the front is at the bottom of the
/// picture.
///
/// up  one of the six axes: (0, 1, 0), (0, 0, -1), ...
Framing named_view(NamedView view, const glm::dvec3& up);

/// Which of y and z is up in a world whose file does not say: `usual`, which is (0, 1, 0) or (0, 0, 1), unless
/// the world rests on a flat bottom along the other one and not along the usual one. (It rests where triangles
/// that lie flat on the lower side of its bounding box cover at least a hundredth of that, and four times as
/// much as along the usual axis.) Any other `usual` is returned as it is.
glm::dvec3 upward_axis(const World& world, const glm::dvec3& usual);

/// A camera turned around the axis through `middle`, counter-clockwise seen from its tip.
/// axis  of any length but 0
Camera turned_camera(
    const Camera& camera, const glm::dvec3& middle, const glm::dvec3& axis, double angle_rad);

} // namespace firsthit
