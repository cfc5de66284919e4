// sky.h - the directions of a sky, and its light at any points.
#pragma once

#include <firsthit/occlusion.h>
#include <firsthit/options/sky_options.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// The directions towards the sky, unit vectors: a spherical Fibonacci lattice, in which direction k has the
/// height (k + 0.5) / count. None lies along an axis of the world where `up` does. The same bits on all machines.
///
/// count   0 to Sky::kMostDirections
/// up      towards the zenith, any length but 0
/// throws  ArgumentError: a count out of range, an `up` that is 0 or not finite
///
/// source  González 2010, "Measurement of Areas on a Sphere Using Fibonacci and Latitude-Longitude Lattices"
std::vector<glm::dvec3> sky_directions(int count, const glm::dvec3& up);

/// Points that receive light of the sky.
struct SkyPoints {
    std::span<const glm::vec3> positions;     // (N) world space
    std::span<const glm::vec3> normals;       // (N) unit
    std::span<const std::uint32_t> receivers; // (N) as Occlusion's, or empty
};

/// The light that arrives at points from the sky and the ground, as a picture of a white surface shows it: for
/// points that are not the hits of a picture. A direction on the other side of the receiver's plane than
/// the normal is hidden.
///
/// sky     with its own `up`
/// light   (N) receives linear Rec.709
/// throws  ArgumentError: as Occlusion; a sky out of range; a number of normals other than that of points
void sky_light(Occlusion& occlusion, const World& world, const Sky& sky, const SkyPoints& points,
    std::vector<glm::vec3>& light);

} // namespace firsthit
