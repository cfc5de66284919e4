// topology.h - which vertices the triangles of a frame join, and whether two frames are alike in that.
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace firsthit {

/// (T) numbers of vertices. Those of two frames mean the same vertices where the triangles of both join the
/// same numbers.
using Topology = std::vector<glm::uvec3>;

/// The topology of a scene that does not move.
///
/// corners  (T) the file's own numbers; empty: those of the scene. Where no two triangles share one,
///          corners with equal positions are the same vertex
Topology topology_of(const Scene& scene, std::vector<glm::uvec3> corners);

/// For each corner of frame a (3 * triangle + k) the corner of frame b with the same vertex.
struct CornerMap {
    std::vector<std::uint32_t> corner; // (3 T); empty: each is its own

    std::uint32_t of(std::uint32_t a) const { return corner.empty() ? a : corner[a]; }
};

/// How the corners of two frames of the same topology belong together; nothing where it is another. The
/// triangles of both join the same vertices, in order; but where a few triangles that follow each other have
/// together the same vertices, they are a polygon that was cut in another way.
std::optional<CornerMap> match(const Topology& a, const Topology& b);

} // namespace firsthit
