// view.h - the camera and the rays of a picture.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace firsthit {

/// A pinhole camera, or an orthographic one. `direction` and `up` may have any length but 0, and need
/// not be perpendicular, but they must not be parallel.
///
/// The result of a camera calibration can be used directly. With focal lengths fx and fy, principal
/// point (cx, cy) and skew s, the point (x, y, z) in the camera's frame (x right, y down, z
/// forward) appears at (fx x/z + s y/z + cx, fy y/z + cy) in pixels. Here (0, 0) is the picture's
/// top left corner, and pixel (i, j) has its centre at (i + 0.5, j + 0.5). In OpenCV (0, 0) is the
/// centre of the first pixel: add 0.5 to its cx and cy; fx, fy and s are the same.
struct Camera {
    glm::dvec3 eye{0, 0, 3};        // position, world space
    glm::dvec3 direction{0, 0, -1}; // the direction that it looks in, world space
    glm::dvec3 up{0, 1, 0};         // the direction that is up in the picture, world space
    /// Full vertical angle, in (0, pi); unused if `focal` is set.
    double fov_y_rad = 0.78539816339744831;

    /// fx and fy in pixels of the view's picture, 1e-12 to 1e15. Empty: both follow from fov_y_rad.
    std::optional<glm::dvec2> focal{};
    /// cx and cy in pixels, -131072 to 131072, also outside of the picture. Empty: the centre.
    std::optional<glm::dvec2> principal_point{};
    double skew = 0; // s in pixels, -1000 fx to 1000 fx

    /// Makes the camera orthographic: the height of the picture in world units, above 0. Its rays are
    /// parallel. They start in the plane through the eye that is perpendicular to `direction`, and what
    /// lies behind that plane is not seen. fov_y_rad is unused; focal, principal_point and skew must not
    /// be set. Rendered by Engine::cpu.
    std::optional<double> orthographic_height{};
};

/// A rectangle of pixels of a picture, counted from its top left.
struct Region {
    int x = 0;      // leftmost column
    int y = 0;      // topmost row
    int width = 0;  // 0: to the picture's edge
    int height = 0; // 0: to the picture's edge
};

/// The rays of a picture. Count pixels (i, j) from the top left, i to the right and j down. In the
/// camera's frame (x right, y down, z forward) the ray of pixel (i, j) has the direction
/// (i + 0.5 - width / 2, j + 0.5 - height / 2, f) with f = height / (2 tan(fov_y_rad / 2)). For a
/// camera with fx, fy, cx, cy and s, the direction is (u, v, 1) with v = (j + 0.5 - cy) / fy and
/// u = (i + 0.5 - cx - s v) / fx. For an orthographic camera of height h, the ray starts at
/// ((i + 0.5 - width / 2) h / height, (j + 0.5 - height / 2) h / height, 0) and has the direction
/// (0, 0, 1). A region has the same rays as the whole picture, so its results have the same bits.
struct View {
    Camera camera;     // position, direction and lens
    int width = 1024;  // pixels, 1 to 65536; a region may have at most 2^28 pixels
    int height = 1024; // pixels, 1 to 65536
    Region region;     // the pixels to render; the whole picture by default
};

} // namespace firsthit
