// shadow_ray.cpp - exact predicate: whether a triangle shadows a point from a light.
#include "exact/shadow_ray.h"

#include "exact/expansion.h"

#include <glm/geometric.hpp>

namespace firsthit {
namespace {

using glm::vec3;

/// facing * N . (d - v0) > (of_point + of_corners) * (|N.x| + |N.y| + |N.z|), by expansions. N is
/// the sum of a x b over the edges, whose products of two floats are exact in double.
bool exactly_behind(const Corners& c, int facing, const vec3& d, float of_point, float of_corners)
{
    Expansion<6> n[3];
    for (int k = 0; k < 3; ++k) {
        const vec3 &a = c[std::size_t(k)], &b = c[std::size_t((k + 1) % 3)];
        for (int axis = 0; axis < 3; ++axis) {
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            n[axis].add(double(a[i]) * double(b[j]));
            n[axis].add(-(double(a[j]) * double(b[i])));
        }
    }
    Expansion<144> height; // 3 axes * 4 factors * 6 components * 2 doubles for each product
    for (int axis = 0; axis < 3; ++axis) {
        height.add_scaled(n[axis], double(facing) * double(d[axis]));
        height.add_scaled(n[axis], -double(facing) * double(c[0][axis]));
        height.add_scaled(n[axis], -double(of_point) * n[axis].sign());
        height.add_scaled(n[axis], -double(of_corners) * n[axis].sign());
    }
    return height.sign() > 0;
}

/// The same, but uses expansions only where double precision is uncertain.
bool is_behind(const Corners& c, int facing, const vec3& d, float of_point, Effort& effort)
{
    const float of_corners = corner_margin(c);
    const double margin = double(of_point) + double(of_corners);
    const glm::dvec3 v0(c[0]), e1 = glm::dvec3(c[1]) - v0, e2 = glm::dvec3(c[2]) - v0,
                               h = glm::dvec3(d) - v0;
    double height = 0, size = 0, length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const double plus = e1[i] * e2[j], minus = e1[j] * e2[i];
        const double n = plus - minus, n_size = std::abs(plus) + std::abs(minus);
        height += n * h[axis];
        length += std::abs(n);
        // Roundings of height: three in the terms of n, then its own, the difference h, the
        // product, two sums. The margin's side of the inequality has as many.
        size += n_size * (std::abs(h[axis]) + margin);
    }
    const double ahead = facing * height - margin * length;
    if (std::abs(ahead) > 16 * kUlp * size) return ahead > 0;
    ++effort.exact_calls;
    return exactly_behind(c, facing, d, of_point, of_corners);
}

} // namespace

namespace {

double largest(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The rows of a rotation that turns the unit vector z to z. Starts from the world axis that is most
/// perpendicular to it, so that a light along a world axis has world axes.
glm::dmat3 axes_along(const glm::dvec3& z)
{
    const glm::dvec3 size = glm::abs(z);
    glm::dvec3 away(0);
    away[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const glm::dvec3 x = glm::normalize(glm::cross(away, z));
    return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

} // namespace

bool is_far_lamp(const Light& light, float farthest)
{
    return light.kind != Light::Kind::directional &&
           largest(light.position) > kFarLamp * double(farthest);
}

PencilSpace light_space(const Light& light, const glm::dvec3& eye, float farthest)
{
    PencilSpace space;
    space.directional = light.kind == Light::Kind::directional || is_far_lamp(light, farthest);
    if (!space.directional) {
        space.origin = glm::vec3(light.position);
        space.reach = float(largest(light.position) + largest(eye));
        return space;
    }
    const bool far = light.kind != Light::Kind::directional;
    const glm::dvec3 along = far ? -light.position : light.direction;
    // Scaled before it is normalised, as squares of the coordinates could under- or overflow.
    space.axes = axes_along(glm::normalize(along / largest(along)));
    space.reach = float(largest(eye));
    if (far) {
        space.distance = glm::length(light.position);
        space.lamp = glm::vec3(light.position);
    }
    return space;
}

Corners weight_corners(const PencilSpace& space, const Corners& c)
{
    if (!(space.distance > 0)) return pencil_corners(space, c);
    Corners to;
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = 1 - double(c[k].z) / space.distance; // D / (D + z) of the world's z
        to[k] = vec3(glm::dvec3(double(c[k].x), double(c[k].y), 1) / share);
    }
    return to;
}

Receiver receiver_of(const Corners& c, int side)
{
    if (side == 0) return {};
    const glm::dvec3 e1 = glm::dvec3(c[1]) - glm::dvec3(c[0]),
                     e2 = glm::dvec3(c[2]) - glm::dvec3(c[0]), n = glm::cross(e1, e2);
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (largest == 0) return {};
    return {vec3(n / (-side * largest)), corner_margin(c)};
}

bool is_shadowed(const PencilSpace& space, const Corners& c, const vec3& d, Effort& effort)
{
    if (!usable(c) || !has_shadow_ray(space, d)) return false;
    const Corners pencil = pencil_corners(space, c);
    const vec3 ray = pencil_ray(space, d);
    const int facing = volume_sign(pencil, effort);
    return facing != 0 && edge_sign(pencil[0], pencil[1], ray, effort) == facing &&
           edge_sign(pencil[1], pencil[2], ray, effort) == facing &&
           edge_sign(pencil[2], pencil[0], ray, effort) == facing &&
           is_behind(c, facing, d, shadow_margin(space, d), effort);
}

int light_side(const PencilSpace& space, const Corners& c, Effort& effort)
{
    return usable(c) ? volume_sign(pencil_corners(space, c), effort) : 0;
}

} // namespace firsthit
