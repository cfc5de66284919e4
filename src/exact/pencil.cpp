// pencil.cpp - a camera's frame and its samples.
#include "exact/pencil.h"

#include "exact/hit.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <limits>
#include <numbers>

namespace firsthit {

namespace {

/// Far from where f times a vertex would leave what can be seen (kFarthest), yet a field of view
/// far below what the vertices' floats resolve.
constexpr double kLongestFocal = 1e15;   // in samples
constexpr double kShortestFocal = 1e-12; // in pixels

/// With 16 x 16 samples in each pixel of the largest picture, directions stay below 2^22.
constexpr double kFarthestPrincipalPoint = 131072; // in pixels

constexpr double kGreatestSkew = 1000; // times fx

constexpr double kLeastHeight = 1e-12, kGreatestHeight = 1e12; // of an orthographic picture

/// A camera's intrinsics, in samples.
struct Intrinsics {
    glm::dvec2 f{1};
    glm::dvec2 principal_point{0};
    double skew = 0;
};

glm::dvec2 focal_of(const View& view, int samples)
{
    const Camera& camera = view.camera;
    if (camera.focal) {
        const glm::dvec2& f = *camera.focal;
        if (!(f.x >= kShortestFocal && f.y >= kShortestFocal && f.x * samples <= kLongestFocal &&
                f.y * samples <= kLongestFocal))
            throw ArgumentError(fmt::format("focal lengths {:g} and {:g} pixels are out of range: "
                                            "both have to be at least {:g}, and at most {:g} "
                                            "samples",
                f.x, f.y, kShortestFocal, kLongestFocal));
        return f * double(samples);
    }
    if (!(camera.fov_y_rad > 0 && camera.fov_y_rad < std::numbers::pi))
        throw ArgumentError(fmt::format(
            "field of view {} rad is out of range: between 0 and pi", camera.fov_y_rad));
    const double f = 0.5 * view.height * samples / std::tan(0.5 * camera.fov_y_rad);
    if (!(f <= kLongestFocal))
        throw ArgumentError(fmt::format("field of view {} rad is too small: the focal length is "
                                        "{:g} samples, at most {:g} are accepted",
            camera.fov_y_rad, f, kLongestFocal));
    return glm::dvec2(f);
}

Intrinsics intrinsics_of(const View& view, int samples)
{
    const Camera& camera = view.camera;
    Intrinsics intrinsics;
    intrinsics.f = focal_of(view, samples);
    glm::dvec2 centre(0.5 * view.width, 0.5 * view.height);
    if (camera.principal_point) {
        centre = *camera.principal_point;
        if (!(std::abs(centre.x) <= kFarthestPrincipalPoint &&
                std::abs(centre.y) <= kFarthestPrincipalPoint))
            throw ArgumentError(
                fmt::format("principal point ({:g}, {:g}) is out of range: each coordinate's size "
                            "has to be at most {:g} pixels",
                    centre.x, centre.y, kFarthestPrincipalPoint));
    }
    intrinsics.principal_point = centre * double(samples);
    intrinsics.skew = camera.skew * samples;
    if (!(std::abs(intrinsics.skew) <= kGreatestSkew * intrinsics.f.x))
        throw ArgumentError(fmt::format("skew {:g} pixels is out of range: its size has to be at "
                                        "most {:g} times the focal length {:g}",
            camera.skew, kGreatestSkew, intrinsics.f.x / samples));
    return intrinsics;
}

/// The samples in a world unit of an orthographic camera, in the place of its focal lengths.
Intrinsics orthographic_scale(const View& view, int samples)
{
    const Camera& camera = view.camera;
    const double height = *camera.orthographic_height;
    if (camera.focal || camera.principal_point || camera.skew != 0)
        throw ArgumentError("an orthographic camera has no focal lengths, principal point or skew");
    if (!(kLeastHeight <= height && height <= kGreatestHeight))
        throw ArgumentError(
            fmt::format("orthographic height {:g} is out of range: {:g} to {:g} world "
                        "units",
                height, kLeastHeight, kGreatestHeight));
    Intrinsics intrinsics;
    intrinsics.f = glm::dvec2(view.height * double(samples) / height);
    intrinsics.principal_point = glm::dvec2(0.5 * view.width, 0.5 * view.height) * double(samples);
    return intrinsics;
}

/// The nearest multiple of 1/2; of two, the greater.
double whole_halves(double x)
{
    return std::floor(2 * x + 0.5) * 0.5;
}

/// Where a point's row of numbers times a factor is added, unless it is 0: so the bits without it
/// stay what they are, zeros' signs too.
void add_scaled(glm::dvec3& sum, double factor, const glm::dvec3& v)
{
    if (factor != 0) sum += factor * v;
}

} // namespace

Pencil pencil_of(const View& view, const Region& region, int samples, const PixelSteps& steps)
{
    const Camera& camera = view.camera;
    const Intrinsics intrinsics = camera.orthographic_height ? orthographic_scale(view, samples)
                                                             : intrinsics_of(view, samples);
    const glm::dvec3 right = glm::cross(camera.direction, camera.up);
    const double reach = glm::length(camera.direction) * glm::length(camera.up);
    if (!(glm::length(right) > 1e-12 * reach) || !std::isfinite(reach) ||
        !std::isfinite(glm::length(camera.eye)))
        throw ArgumentError("the camera needs a finite eye, and a direction and an up vector that "
                            "are neither zero nor parallel");

    Pencil pencil;
    const glm::dvec3 z = glm::normalize(camera.direction);
    const glm::dvec3 x = glm::normalize(right);
    const glm::dvec3 y = glm::cross(z, x); // down
    const glm::dvec2 f = intrinsics.f;
    const glm::dvec2 middle(
        whole_halves(intrinsics.principal_point.x), whole_halves(intrinsics.principal_point.y));
    const glm::dvec2 rest = intrinsics.principal_point - middle;
    const double skew = intrinsics.skew;
    const glm::dvec2 step(steps.x, steps.y);
    pencil.eye = camera.eye;
    pencil.f = f / step;
    pencil.parallel = camera.orthographic_height.has_value();

    // Eye space.
    glm::dvec3 row_x = f.x * x, row_y = f.y * y;
    add_scaled(row_x, skew, y);
    add_scaled(row_x, rest.x, z);
    add_scaled(row_y, rest.y, z);
    pencil.eye_from_world = glm::transpose(glm::dmat3(row_x / step.x, row_y / step.y, z));

    // And back: from X = f.x x + skew y + rest.x, Y = f.y y + rest.y to x and y.
    pencil.shear = {-skew / f.x, (skew * (rest.y / f.y) - rest.x) / f.x, -rest.y / f.y};
    glm::dvec3 down = y, forward = z;
    add_scaled(down, pencil.shear.x, x);
    add_scaled(forward, pencil.shear.y, x);
    add_scaled(forward, pencil.shear.z, y);
    pencil.world_from_axes = glm::dmat3(x, down, forward);

    pencil.width = region.width * samples;
    pencil.height = region.height * samples;
    pencil.x0 = (double(region.x) * samples * step.x + 0.5 - middle.x) / step.x;
    pencil.y0 = (double(region.y) * samples * step.y + 0.5 - middle.y) / step.y;
    return pencil;
}

void reach_all(std::span<const glm::vec3> position, Pencil& pencil)
{
    if (!pencil.parallel) return;
    const glm::dmat3& m = pencil.eye_from_world;
    double farthest = 0, nearest = std::numeric_limits<double>::infinity();
    for (const glm::vec3& p : position) {
        if (!usable(p)) continue;
        const glm::dvec3 d = glm::dvec3(p) - pencil.eye;
        const double z = (m[0][2] * d.x + m[1][2] * d.y) + m[2][2] * d.z;
        if (!(z > 0)) continue;
        farthest = std::max(farthest, z);
        nearest = std::min(nearest, z);
    }
    // What lies in one plane gets some depth, and the numbers stay apart from one another.
    double deep = std::max(farthest - nearest, 0x1p-10 * farthest);
    if (!(deep > 0x1p-60)) deep = 1;
    pencil.far = farthest + deep;
    pencil.scale = deep;
    pencil.nearest = float(deep / pencil.far);
}

} // namespace firsthit
