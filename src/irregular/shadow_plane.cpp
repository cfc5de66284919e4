// shadow_plane.cpp - decides in double whether a point is behind a triangle's plane, where that is
// certain.

#include "irregular/shadow_plane.h"

#include "exact/shadow_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

using glm::dvec3;

/// A computed value, and the size that its roundings are relative to: the sum of its terms' sizes.
struct Sized {
    double value, size;
};

Sized minor(double a, double b, double c, double d)
{
    const double plus = a * d, minus = b * c;
    return {plus - minus, std::abs(plus) + std::abs(minus)};
}

// Relative errors. In a pencil with an origin, x, y and w of samples and corners are off by 2^-24
// of their size, and the roundings of doubles are negligible beside that. A parallel pencil has
// only the latter.
constexpr double kPencilError = 0x1p-22, kParallelError = 0x1p-40;
constexpr double kSteepest = 0x1p-20;   // a divisor below this share of its terms is too inexact
constexpr double kMarginRoom = 0x1p-18; // relative error of the margins

} // namespace

ShadowPlane::ShadowPlane(const PencilMesh& mesh, std::uint32_t triangle)
    : directional_(mesh.space.directional),
      reach_(double(mesh.space.reach))
{
    const Corners corners = mesh.corners(triangle);
    const dvec3 a(mesh.face.to_face_axes(corners[0])), b(mesh.face.to_face_axes(corners[1])),
        c(mesh.face.to_face_axes(corners[2]));
    const dvec3 p = b - a, q = c - a;
    const Sized nx = minor(p.y, p.z, q.y, q.z), ny = minor(p.z, p.x, q.z, q.x),
                nz = minor(p.x, p.y, q.x, q.y);
    Sized divisor = nz;
    if (!directional_)
        divisor = {nx.value * a.x + ny.value * a.y + nz.value * a.z,
            nx.size * std::abs(a.x) + ny.size * std::abs(a.y) + nz.size * std::abs(a.z)};
    corner_margin_ = double(corner_margin(corners));
    ec_ = std::numeric_limits<double>::infinity();
    if (!(std::abs(divisor.value) > kSteepest * divisor.size)) return;
    const double over = 1 / divisor.value, error = directional_ ? kParallelError : kPencilError;
    wx_ = nx.value * over;
    wy_ = ny.value * over;
    ex_ = error * nx.size * std::abs(over);
    ey_ = error * ny.size * std::abs(over);
    length_ = (std::abs(nx.value) + std::abs(ny.value) + std::abs(nz.value)) * std::abs(over);
    if (directional_) {
        x_ = a.x, y_ = a.y;
        wc_ = -a.z;
        ec_ = error * std::abs(a.z);
    } else {
        wc_ = nz.value * over;
        ec_ = error * nz.size * std::abs(over);
    }
}

Verdict ShadowPlane::classify(float x, float y, float w) const
{
    const double dx = double(x) - x_, dy = double(y) - y_, size = std::abs(double(w));
    const double ahead = wx_ * dx + wy_ * dy + wc_ - double(w);
    const double error = ex_ * std::abs(dx) + ey_ * std::abs(dy) + ec_ +
                         (directional_ ? kParallelError : kPencilError) * size;
    double of_point = 0, per_margin = 1; // shadow_margin / kShadowMargin and 1, both divided by c
    if (directional_) {
        of_point = 2 * std::max({std::abs(double(x)), std::abs(double(y)), size}) + reach_;
    } else {
        of_point = 2 * std::max({1.0, std::abs(double(x)), std::abs(double(y))}) + reach_ * size;
        per_margin = size;
    }
    const double margin = double(kShadowMargin) * of_point + corner_margin_ * per_margin;
    const double room = kMarginRoom * margin + 2 * kMarginUnderflow * per_margin;
    // Comparisons with NaN are false, and leave it undecided.
    if (ahead - error > length_ * (margin + room)) return Verdict::shadowed;
    if (ahead + error < length_ * (margin - room)) return Verdict::lit;
    return Verdict::undecided;
}

} // namespace firsthit
