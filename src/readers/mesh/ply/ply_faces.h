// ply_faces.h - makes triangles of the faces and strips of a PLY file.
#pragma once

#include "readers/mesh/raw_mesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// One face as the file has it. Kept from face to face, so that nothing is allocated for each.
struct PlyFace {
    std::vector<std::uint32_t> corner; // vertices
    std::vector<float> texcoord;       // u and v of each corner; or anything else, and not used
    glm::vec4 color{1};                // as in the file: see ply_color.h
};

/// The triangles of a run of faces.
struct PlyTriangles {
    std::vector<glm::uvec3> index;
    std::vector<glm::vec2> uv;        // of corners of faces; empty where faces have none
    std::vector<glm::uvec3> uv_index; // into uv
    std::vector<glm::vec4> color;     // as in the file; empty where faces have none
    std::size_t thin = 0;             // faces with fewer than 3 corners
    std::size_t first_thin = 0;       // the first of them
    std::size_t crossed = 0;          // faces whose outline crosses itself
    std::size_t first_crossed = 0;    // the first of them
    std::size_t without_uv = 0;       // faces whose texture coordinates are not two a corner
    std::size_t first_without_uv = 0; // the first of them
};

/// Appends the triangles of faces.
class PlyTriangleMaker {
  public:
    /// position  of all vertices; polygons of more than three corners are cut by them
    /// has_uv    faces have texture coordinates
    /// colored   faces have colours
    PlyTriangleMaker(std::span<const glm::vec3> position, bool has_uv, bool colored)
        : position_(position),
          has_uv_(has_uv),
          colored_(colored)
    {
    }

    PlyTriangles triangles;

    /// number  of the face. Its corners are vertices that exist
    void add(const PlyFace& face, std::size_t number)
    {
        const std::vector<std::uint32_t>& corner = face.corner;
        if (corner.size() == 3 && !has_uv_ && !colored_)
            triangles.index.emplace_back(corner[0], corner[1], corner[2]);
        else
            add_any(face, number);
    }

    /// Triangles of each three vertices in a row, every second one turned round. A negative vertex
    /// starts again.
    void add_strip(std::span<const std::int64_t> vertices);

  private:
    void add_any(const PlyFace& face, std::size_t number);

    std::span<const glm::vec3> position_;
    bool has_uv_, colored_;
    std::vector<glm::vec3> outline_;
    std::vector<glm::uvec3> cut_; // triangles of corners of a face
};

/// Appends the parts, which follow one another in the file, to the mesh.
void append_triangles(std::vector<PlyTriangles>& parts, RawMesh& mesh);

} // namespace firsthit
