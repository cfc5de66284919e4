// view.h - where the eye is and which rays it sends.
#pragma once

#include <glm/vec3.hpp>

namespace firsthit {

/// A pinhole camera. `direction` and `up` need not be unit nor perpendicular, but not parallel.
struct Camera {
    glm::dvec3 eye{0, 0, 3};                // world space
    glm::dvec3 direction{0, 0, -1};         // the way the camera looks, world space
    glm::dvec3 up{0, 1, 0};                 // what is up in the picture, world space
    double fov_y_rad = 0.78539816339744831; // full vertical angle, in (0, pi)
};

/// A rectangle of pixels, origin at the picture's top left.
struct Region {
    int x = 0;      // of the left column
    int y = 0;      // of the top row
    int width = 0;  // 0: to the picture's edge
    int height = 0; // 0: to the picture's edge
};

/// A picture's rays. Pixel (i, j), i to the right and j down from the top left, has the direction
/// (i + 0.5 - width / 2, j + 0.5 - height / 2, f) in a frame with x right, y down, z forward, where
/// f = height / (2 tan(fov_y / 2)). A region selects some of the same rays, so the same bits.
struct View {
    Camera camera;     // where the eye is
    int width = 1024;  // 1 to 65536; at most 2^28 pixels in a region
    int height = 1024; // as width
    Region region;     // all of the picture by default
};

} // namespace firsthit
