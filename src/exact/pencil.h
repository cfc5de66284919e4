// pencil.h - the rays of one picture: all through the eye, one through each sample.
#pragma once

#include "base/pixel_steps.h"

#include <firsthit/view.h>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace firsthit {

/// Samples from a first one on, that of a pencil, a tile or a block: the ray of sample (x, y) has the
/// direction (x0 + x, y0 + y, 1) in eye space. Exact: multiples of 1/2 below 2^22, or of 1/32 below 2^18.
struct LatticeTile {
    float x0 = 0;
    float y0 = 0;

    /// The samples from (x, y) on.
    constexpr LatticeTile from(int x, int y) const { return {x0 + float(x), y0 + float(y)}; }

    constexpr glm::vec3 direction(int x, int y) const
    {
        return {x0 + float(x), y0 + float(y), 1.0f};
    }

    /// No |x| and |y| of the directions of width x height samples are greater, nor of one sample more.
    glm::dvec2 reach(int width, int height) const
    {
        const double x = x0, y = y0;
        return {std::max(std::abs(x), std::abs(x + width)),
            std::max(std::abs(y), std::abs(y + height))};
    }
};

/// A rectangle of the samples of a picture, and the space in which their rays are exact.
///
/// Eye space is the camera's frame (x right, y down, z forward) with x and y multiplied by the focal
/// lengths in samples, and sheared where the camera has a skew, or a principal point that lies at
/// no half sample: (f.x x + skew y + r.x z, f.y y + r.y z, z), r what is left of the principal point
/// when whole half samples are taken out of it. There the ray of sample (i, j) of the rectangle has
/// the direction (x0 + i, y0 + j, 1): multiples of 1/2, exact in float. Depth along the axis is z.
///
/// Where only some pixels are shot (base/pixel_steps.h), these are the samples: x and y, and all that is
/// counted in samples, are divided by the steps, which are powers of two.
struct Pencil {
    glm::dvec3 eye{0};
    glm::dmat3 eye_from_world{1};
    /// Columns: right, down, forward. The ray of (X, Y, 1) of eye space goes along X / f.x right + Y /
    /// f.y down + forward in world space. Orthonormal unless the pencil is sheared.
    glm::dmat3 world_from_axes{1};
    glm::dvec2 f{1}; // in samples
    /// In the camera's frame, down is (shear.x, 1, 0) and forward is (shear.y, shear.z, 1).
    glm::dvec3 shear{0};
    int width = 0; // samples in the rectangle
    int height = 0;
    double x0 = 0; // direction of its first sample
    double y0 = 0;

    /// Rays along z instead: moved into this space, a point becomes (x s, y s, s), s = scale / (far -
    /// z). Planes stay planes, x s / s = x, and 1 / s is affine in x and y, as 1 / z is of a pinhole
    /// camera. All points have to have z < far.
    bool parallel = false;
    double far = 0;
    double scale = 1;
    /// Of an orthographic camera: what has no greater s is behind its eye. 0: everything is seen.
    float nearest = 0;

    /// The z of what has s, where the rays are parallel.
    double parallel_depth(double s) const { return far - scale / s; }

    /// The samples from (x, y) of the rectangle on.
    LatticeTile tile(int x, int y) const { return {float(x0 + x), float(y0 + y)}; }
};

/// The widest and highest rectangle that is rasterised at once, in samples.
inline constexpr int kMaxPencil = 8192;

/// The rays of `region` (pixels of the view's picture) with samples x samples rays a pixel, which
/// are the pixel rays of a picture `samples` times as wide and high. With steps, which need one sample,
/// `region` is counted in steps, as PixelSteps::shot does. An orthographic camera's rays are complete once
/// reach_all() has been called.
/// throws  ArgumentError: a camera without a direction; a field of view, focal length, principal point or
///         skew out of range (firsthit/view.h); f above 1e15 samples; or an orthographic height out of
///         range, or with a lens
Pencil pencil_of(const View& view, const Region& region, int samples, const PixelSteps& steps = {});

/// Finds `far`, `scale` and `nearest` of an orthographic camera's rays, so that all vertices in front of its
/// eye get an s from 1/2 to 1. Leaves other pencils alone.
///
/// position  (V) in world space
void reach_all(std::span<const glm::vec3> position, Pencil& pencil);

} // namespace firsthit
