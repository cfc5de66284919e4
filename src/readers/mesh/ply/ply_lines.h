// ply_lines.h - reads the text of a PLY file in parts, by several threads.
#pragma once

#include "base/tasks.h"
#include "readers/mesh/ply/ply_elements.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace firsthit {

/// What is read.
struct PlyLinesJob {
    const PlyElement& vertex; // the first element of the text
    const PlyElement& faces;  // the second, of the kind faces
    std::span<glm::vec3> position;
    const std::vector<PlyColumn>& columns;
};

/// Reads vertices and faces of a text in which each is one line, as nearly all are. The numbers are those
/// that reading word by word gives, whatever the number of threads.
///
/// body     the text behind the header; a zero or white space follows it
/// parts    gets the triangles
/// returns  the bytes that were read; nothing where a line is not one element, an index is out of range or
///          a number has a form that is seldom: then it has to be read word by word
std::optional<std::size_t> read_ply_lines(
    std::string_view body, const PlyLinesJob& job, std::vector<PlyTriangles>& parts, Tasks& tasks);

} // namespace firsthit
