// obj_colors.h - the colours of an OBJ file's vertices, which the format itself does not know.
#pragma once

#include "readers/mesh/raw_mesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace firsthit {

/// Collects colours as most programs write them: three numbers behind a position, sRGB from 0 to 1; or as
/// ZBrush does, in comments "#MRGB MMRRGGBBMMRRGGBB..." of hexadecimal codes for one vertex
/// after the other (MM is a mask).
class ObjColors {
  public:
    /// The colour of a vertex; vertices without one are white.
    void add(std::size_t vertex, const glm::vec3& srgb);

    /// What follows "#MRGB". What is no code ends it.
    void add_codes(std::string_view text);

    /// Fills RawMesh::color, where there are any.
    void finish(RawMesh& mesh) const;

  private:
    std::vector<glm::vec3> srgb_;      // (vertices up to the last that has one)
    std::vector<std::uint32_t> codes_; // 0xRRGGBB
};

} // namespace firsthit
