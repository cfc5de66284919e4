// pencil.h - the rays of one picture: all through the eye, one through each sample.
#pragma once

#include <firsthit/view.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace firsthit {

/// A rectangle of the samples of a picture, and the space in which their rays are exact.
///
/// Eye space is the camera's frame (x right, y down, z forward) with x and y multiplied by f, the
/// focal length in samples. There the ray of sample (i, j) of the rectangle has the direction
/// (x0 + i, y0 + j, 1): multiples of 1/2, exact in float. Depth along the axis is z.
struct Pencil {
    glm::dvec3 eye{0};
    glm::dmat3 eye_from_world{1};  // rows: f * right, f * down, forward
    glm::dmat3 world_from_axes{1}; // columns: right, down, forward; orthonormal
    double f = 1;                  // in samples
    int width = 0;                 // samples in the rectangle
    int height = 0;
    double x0 = 0; // direction of its first sample
    double y0 = 0;

    /// Rays along z instead: moved into this space, a point becomes (x s, y s, s), s = 1 / (far -
    /// z). Planes stay planes, x s / s = x, and 1 / s is affine in x and y, as 1 / z is of a pinhole
    /// camera. All points have to have z < far.
    bool parallel = false;
    double far = 0;
};

/// The widest and highest rectangle that is rasterised at once, in samples.
inline constexpr int kMaxPencil = 8192;

/// The rays of `region` (pixels of the view's picture) with samples x samples rays a pixel, which
/// are the pixel rays of a picture `samples` times as wide and high.
/// throws  ArgumentError: a camera without a direction, or a field of view out of range: not
///         between 0 and pi, or so small that f is above 1e15
Pencil pencil_of(const View& view, const Region& region, int samples);

} // namespace firsthit
