// raw_mesh.h - what a mesh file holds, before it becomes a scene.
#pragma once

#include "base/tasks.h"
#include "readers/problems.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// Bytes. A guard: every vertex of a file has to have a number of 32 bits.
inline constexpr std::size_t kMaxMeshFile = 0xFFFFFFFF;

/// A guard: a face of more corners is damage.
inline constexpr std::int64_t kMaxCorners = 65536;

/// Triangle ids stay below kNoItem, and a triangle may bring three vertices with it.
inline constexpr std::size_t kMaxFileTriangles = 0x50000000;

/// The triangles from `first_triangle` to the next run's are one instance with this material.
struct MeshRun {
    std::size_t first_triangle = 0;
    std::uint32_t material = 0; // into RawMesh::materials; their number: the default one
    std::string name{};         // of the instance; empty: the material's
};

/// Triangles in file order, vertices as the file has them: not welded. A face of n corners is the
/// fan of n - 2 triangles around its first corner; faces of fewer than three are left out.
struct RawMesh {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3>
        normal;                // zero where the file gives none; empty where it gives none at all
    std::vector<glm::vec2> uv; // v = 0 at the bottom, as in the file; may be empty
    std::vector<glm::vec4> color; // of vertices, linear red, green, blue, and alpha; may be empty
    std::vector<glm::vec4> triangle_color; // of triangles, multiplies `color`; may be empty
    std::vector<glm::uvec3> index;
    std::vector<glm::uvec3> normal_index; // into normal; empty: it is `index`
    std::vector<glm::uvec3> uv_index;     // into uv; empty: it is `index`
    std::vector<std::uint32_t>
        smoothing; // smoothing groups of triangles, see smooth_normals.h; may be empty

    std::vector<std::string> materials;      // names, in order of first use; empty: no materials
    std::vector<MeshRun> runs;               // by triangle
    std::vector<std::string> material_files; // as written in the file
    std::string texture;                     // of what has no material, as written in the file
    Problems problems;                       // what was left out or repaired
};

/// Read a file's bytes, at least one triangle. Numbers of texts are rounded once, to float.
///
/// name    of the file, for messages
/// throws  FileError, SceneError: names the file and the line, or the facet, vertex or face (all
///         counted from 0, lines from 1)
RawMesh read_ply(const std::string& bytes, const std::string& name, Tasks& tasks);
RawMesh read_stl(const std::string& bytes, const std::string& name);
RawMesh read_obj(const std::string& bytes, const std::string& name);
RawMesh read_off(const std::string& bytes, const std::string& name);

/// The kind of problem of faces with fewer than three corners.
inline constexpr std::string_view kThinFaces = "faces with fewer than 3 corners are left out";

/// Leaves out triangles with a corner that is not finite, and replaces other values that are not: normals
/// are made, texture coordinates are 0, colours white. Each is a problem. Unused values do not matter, but
/// become finite too.
/// throws  FileError where no triangle is left
void leave_out_not_finite(RawMesh& mesh, const std::string& name);

/// throws  FileError where there is none, or more than kMaxFileTriangles
void check_triangle_count(std::size_t count, const std::string& name);

} // namespace firsthit
