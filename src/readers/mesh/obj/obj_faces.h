// obj_faces.h - the faces of an OBJ file, and the triangles they become when all vertices are known.
#pragma once

#include "readers/mesh/raw_mesh.h"
#include "scene/model/smooth_normals.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// One corner of a face: numbers from 0 of position, texture coordinates and normal, which may be
/// beyond those that the file has.
struct ObjCorner {
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    std::uint32_t vertex = 0;
    std::uint32_t uv = kNone;
    std::uint32_t normal = kNone;
};

/// Keeps faces until the end of the file, as they may stand before their vertices.
class ObjFaces {
  public:
    /// corner  at least 3
    /// line    of the file
    void add(std::span<const ObjCorner> corner, std::size_t line);

    /// The smoothing group of the faces that follow, as smooth_normals.h has them.
    void set_smoothing(std::uint32_t group);

    std::size_t count() const { return end_.size(); }

    /// Fills the mesh's triangles from its positions, normals and texture coordinates, to each of which a zero
    /// is added where corners have none. Corners with texture coordinates or normals that do not exist
    /// have none. Triangles that need a position that is not finite are left out.
    ///
    /// returns  (count + 1) the first triangle of each face, and their number
    /// throws   SceneError: a position that does not exist, with its line
    std::vector<std::size_t> make_triangles(RawMesh& mesh, const std::string& name) const;

  private:
    class Maker;

    std::size_t begin(std::size_t face) const { return face > 0 ? end_[face - 1] : 0; }

    std::vector<ObjCorner> corner_;
    std::vector<std::uint32_t> end_;       // (faces) in corner_
    std::vector<std::uint32_t> line_;      // (faces)
    std::vector<std::uint32_t> smoothing_; // (faces) or empty: none has a group
    std::uint32_t last_vertex_ = 0;        // the greatest that corners name
    bool has_uv_ = false;                  // a corner has
    bool has_normal_ = false;
    std::uint32_t group_ = kNoSmoothingGroup; // of the next face
};

} // namespace firsthit
