// smooth_normals.h - normals for triangles that came without.
#pragma once

#include "base/tasks.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// Of a triangle that has no smoothing group: the angle decides.
inline constexpr std::uint32_t kNoSmoothingGroup = 0xFFFFFFFFu;

struct SmoothNormals {
    std::vector<glm::vec3> normal;     // unit
    std::vector<std::uint32_t> corner; // (3 T) number of each triangle corner's normal
};

/// Makes a normal for every group of triangles around a point that pass into one another across
/// edges less sharp than the crease angle. An edge is smooth if the angle between its triangles'
/// normals is at most that; with pi, all are. Of more than two triangles at an edge, those next to
/// each other in file order are looked at. Triangles without area join no group; where a point has
/// no others its normal is +z.
///
/// A normal belongs to one point alone. With pi, or more, its number is that of the point, whether
/// a triangle uses it or not. Normals do not depend on the number of threads.
///
/// position         of each point; points are distinct
/// index            of each triangle's corners into position
/// crease_angle_rad 0 (flat) to pi (smooth)
/// group            (T) or empty: smoothing groups as OBJ has them. Triangles of one group pass into one
///                  another whatever their angle, those of different groups do not, and those of
///                  group 0 into none; kNoSmoothingGroup is a group of its own, in which the angle decides
/// source           Max 1999, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2):
///                  the weights that are right on a sphere
SmoothNormals smooth_normals(std::span<const glm::vec3> position, std::span<const glm::uvec3> index,
    double crease_angle_rad, Tasks& tasks, std::span<const std::uint32_t> group = {});

/// The same on one thread.
SmoothNormals smooth_normals(std::span<const glm::vec3> position, std::span<const glm::uvec3> index,
    double crease_angle_rad);

} // namespace firsthit
