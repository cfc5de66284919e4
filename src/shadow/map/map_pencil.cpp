// map_pencil.cpp - the rays of a shadow map's texels, and the transform from a point to its texel.
#include "shadow/map/map_pencil.h"

#include "exact/hit.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

/// The least and greatest z of all usable vertices (exact/hit.h), in a parallel light's frame.
struct DepthRange {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
};

DepthRange depth_range(const World& world, const glm::dvec3& z)
{
    DepthRange range;
    for (const glm::vec3& p : world.position) {
        if (!usable(p)) continue;
        const double depth = (z.x * double(p.x) + z.y * double(p.y)) + z.z * double(p.z);
        range.least = std::min(range.least, depth);
        range.greatest = std::max(range.greatest, depth);
    }
    return range;
}

/// The pencil of the map's rays, without the rectangle that is rasterised.
Pencil map_pencil(const World& world, const LightFrame& frame, int face, const MapFit& fit)
{
    const glm::dmat3 rows = glm::transpose(face_matrix(frame, face));
    Pencil pencil;
    const double f = 1 / fit.texel; // texels
    pencil.f = glm::dvec2(f);
    if (!frame.parallel) {
        // Shear the frustum so that its axis goes through the rectangle's middle and numbers stay
        // small.
        pencil.eye = frame.origin;
        pencil.eye_from_world = glm::transpose(glm::dmat3(f * (rows[0] - fit.middle_x * rows[2]),
            f * (rows[1] - fit.middle_y * rows[2]), rows[2]));
        return pencil;
    }
    const DepthRange range = depth_range(world, rows[2]);
    // Depths from 0 to d become values of 1/t from 2 d down to d, which all have the same
    // precision.
    const double wide = fit.texel * std::max(fit.width, fit.height);
    const double deep = std::max(range.greatest - range.least, wide * 0x1p-10);
    pencil.parallel = true;
    pencil.far = 2 * deep;
    pencil.eye = rows[0] * fit.middle_x + rows[1] * fit.middle_y + rows[2] * range.least;
    pencil.eye_from_world = glm::transpose(glm::dmat3(f * rows[0], f * rows[1], rows[2]));
    return pencil;
}

} // namespace

Pencil set_map_transform(const World& world, int face, ShadowMap& map)
{
    const LightFrame& frame = map.source.frame;
    const Pencil pencil = map_pencil(world, frame, face, map.source.fit);
    const glm::dvec3 middle(0.5 * map.width(), 0.5 * map.height(), 0);
    map.origin = pencil.eye;
    map.matrix = pencil.eye_from_world;
    map.offset = glm::dvec3(0);
    if (frame.parallel) {
        map.offset = middle;
    } else {
        glm::dmat3 rows = glm::transpose(map.matrix);
        rows[0] += middle.x * rows[2];
        rows[1] += middle.y * rows[2];
        map.matrix = glm::transpose(rows);
    }
    return pencil;
}

} // namespace firsthit
