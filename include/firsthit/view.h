// view.h - where the eye is and which rays it sends.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace firsthit {

/// A pinhole camera. `direction` and `up` need not be unit nor perpendicular, but not parallel.
///
/// What a calibration gives can be used as it is: with focal lengths fx and fy, principal point
/// (cx, cy) and skew s, the point (x, y, z) of the camera's frame (x right, y down, z forward) is seen at
/// (fx x/z + s y/z + cx, fy y/z + cy) in pixels. Here the picture's top left corner is (0, 0), and
/// pixel (i, j) has its centre at (i + 0.5, j + 0.5). OpenCV counts from the first pixel's centre: add
/// 0.5 to its cx and cy; fx, fy and s are the same.
struct Camera {
    glm::dvec3 eye{0, 0, 3};                // world space
    glm::dvec3 direction{0, 0, -1};         // the way the camera looks, world space
    glm::dvec3 up{0, 1, 0};                 // what is up in the picture, world space
    double fov_y_rad = 0.78539816339744831; // full vertical angle, in (0, pi); unused with `focal`

    /// fx and fy in pixels of the view's picture, 1e-12 to 1e15. None: both follow from fov_y_rad.
    std::optional<glm::dvec2> focal{};
    /// cx and cy in pixels, also outside of the picture, at most 131072 in size. None: the centre.
    std::optional<glm::dvec2> principal_point{};
    double skew = 0; // s in pixels, at most 1000 fx in size
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
/// f = height / (2 tan(fov_y / 2)); or, of a camera with fx, fy, cx, cy and s, (u, v, 1) with
/// v = (j + 0.5 - cy) / fy, u = (i + 0.5 - cx - s v) / fx. A region selects some of the same rays, so
/// the same bits.
struct View {
    Camera camera;     // where the eye is
    int width = 1024;  // 1 to 65536; at most 2^28 pixels in a region
    int height = 1024; // as width
    Region region;     // all of the picture by default
};

} // namespace firsthit
