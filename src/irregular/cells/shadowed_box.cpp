// shadowed_box.cpp - decides whether one triangle, or two that share an edge, certainly shadow
// everything inside a box of the face.
//
// One triangle does if, at the four corners of the box, all its edge functions are positive and its
// plane is nearer to the origin than the nearest point by more than the margin. The corners
// suffice, because edges and depth are affine. All is computed in double; where roundings might
// change a sign, the answer is "not certain", for instance if the origin lies nearly in the
// triangle's plane.
//
// Two triangles with a common edge: a ray that is inside of their other four edges hits one of the
// two, because it lies on one side or the other of the common edge, and the exact sign of that edge
// is the same number for both.
#include "irregular/cells/shadowed_box.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit {
namespace {

using glm::dvec3;

constexpr double kTolerance = 0x1p-20; // relative; far larger than the roundings of doubles

struct FacePoint {
    double x, y;
};

/// The corners of the bounds, moved outwards by more than the roundings of samples' coordinates,
/// which may also have underflowed to 0.
std::array<FacePoint, 4> corners_of(const SampleBounds& b)
{
    const auto out = [](float v) { return 0x1p-22 * std::abs(double(v)) + 0x1p-140; };
    const double x0 = double(b.x0) - out(b.x0), x1 = double(b.x1) + out(b.x1),
                 y0 = double(b.y0) - out(b.y0), y1 = double(b.y1) + out(b.y1);
    return {{{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}}};
}

/// A computed value, and the size that its rounding errors are relative to: the sum of its terms'
/// sizes.
struct Rounded {
    double value = 0, size = 0;

    /// The sign of the exact value; 0 where that is not certain.
    int sign() const { return std::abs(value) > kTolerance * size ? value > 0 ? 1 : -1 : 0; }
};

struct RoundedVector {
    dvec3 value{0}, size{0};
};

RoundedVector cross(const dvec3& a, const dvec3& b)
{
    const dvec3 p = glm::abs(a), q = glm::abs(b);
    return {
        glm::cross(a, b), {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x}};
}

Rounded dot(const RoundedVector& n, const dvec3& p)
{
    return {glm::dot(n.value, p), glm::dot(n.size, glm::abs(p))};
}

/// The cross product of two corners. Each component is the difference of two products of floats,
/// which are exact in double, so that it is rounded once.
RoundedVector corner_product(const dvec3& a, const dvec3& b)
{
    const dvec3 n = glm::cross(a, b);
    return {n, glm::abs(n)};
}

/// Whether the triangle certainly shadows all points inside the bounds that are on the inner side
/// of edge number `open`; this edge alone is not tested (3: all edges are). Returns the sign of the
/// triangle's volume (volume_sign) if so, else 0.
int shadowing_side(const PencilSpace& space, const CubeFace& face, const Corners& corners,
    std::size_t open, const SampleBounds& bounds)
{
    if (!std::isfinite(bounds.farthest_w) || !std::isfinite(bounds.nearest_w)) return 0;
    const bool directional = space.directional;
    std::array<dvec3, 3> v, pencil;
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = dvec3(face.to_face_axes(corners[k]));
        pencil[k] = directional ? dvec3(v[k].x, v[k].y, 1) : v[k];
    }
    const Rounded volume = dot(corner_product(pencil[1], pencil[2]), pencil[0]);
    if (volume.sign() == 0) return 0;
    const std::array<FacePoint, 4> box_corners = corners_of(bounds);
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == open) continue;
        const RoundedVector edge = corner_product(pencil[k], pencil[(k + 1) % 3]);
        for (const FacePoint& at : box_corners)
            if (dot(edge, {at.x, at.y, 1}).sign() != volume.sign()) return 0;
    }

    const RoundedVector n = cross(v[1] - v[0], v[2] - v[0]);
    const Rounded divisor = directional ? Rounded{n.value.z, n.size.z} : volume;
    if (divisor.sign() == 0) return 0;
    const double nearest = bounds.nearest_w;
    // The largest coordinate of a point, divided by its c in a pencil with an origin.
    const double largest = std::max(
        {std::abs(double(bounds.x0)), std::abs(double(bounds.x1)), std::abs(double(bounds.y0)),
            std::abs(double(bounds.y1)), directional ? std::abs(nearest) : 1.0,
            directional ? std::abs(double(bounds.farthest_w)) : 1.0});
    const double per_margin = directional ? 1 : nearest;
    const double margin = double(kShadowMargin) * 2 * largest +
                          (double(kShadowMargin) * double(space.reach) +
                              double(corner_margin(corners)) + kMarginUnderflow) *
                              per_margin;
    const double length = n.size.x + n.size.y + n.size.z; // an upper bound of |N|
    for (const FacePoint& at : box_corners) {
        const Rounded height =
            directional ? dot(n, {at.x - v[0].x, at.y - v[0].y, 0}) : dot(n, {at.x, at.y, 1});
        const double base = directional ? v[0].z : 0;
        const double w = height.value / divisor.value - base;
        const double size = (height.size + margin * length) / std::abs(divisor.value) +
                            std::abs(base) + std::abs(nearest);
        if (!(w - nearest > margin * length / std::abs(divisor.value) + kTolerance * size))
            return 0;
    }
    return volume.sign();
}

} // namespace

bool shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& corners,
    const SampleBounds& bounds)
{
    return shadowing_side(space, face, corners, 3, bounds) != 0;
}

bool pair_shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& first,
    const Corners& second, const SampleBounds& bounds)
{
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const glm::vec3 &a = first[i], &b = first[(i + 1) % 3];
            const glm::vec3 &c = second[j], &d = second[(j + 1) % 3];
            const bool against = a == d && b == c, along = a == c && b == d;
            if (!against && !along) continue;
            const int side = shadowing_side(space, face, first, i, bounds);
            return side != 0 &&
                   shadowing_side(space, face, second, j, bounds) == (against ? side : -side);
        }
    }
    return false;
}

} // namespace firsthit
