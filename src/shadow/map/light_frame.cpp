// light_frame.cpp - the axes of a light's shadow maps.
#include "shadow/map/light_frame.h"

#include "exact/shadow_ray.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace firsthit {

LightFrame light_frame(const Light& light)
{
    LightFrame frame;
    frame.parallel = light.kind == Light::Kind::directional;
    frame.cube = light.kind == Light::Kind::point;
    if (!frame.parallel) frame.origin = light.position;
    if (frame.cube) return frame;

    Light along = light;
    along.kind = Light::Kind::directional;
    frame.axes = light_space(along, glm::dvec3(0)).axes;
    if (!frame.parallel) {
        const double tangent = std::tan(light.outer_rad);
        frame.cube = !(tangent <= kWidestTangent);
        frame.tan2_cone = tangent * tangent;
    }
    return frame;
}

glm::dmat3 face_matrix(const LightFrame& frame, int face)
{
    const FaceAxes axes = face_axes(face);
    const glm::dmat3 rows = glm::transpose(frame.axes);
    return glm::transpose(
        glm::dmat3(rows[axes.x], rows[axes.y], axes.backwards ? -rows[axes.z] : rows[axes.z]));
}

} // namespace firsthit
