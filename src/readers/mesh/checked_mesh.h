// checked_mesh.h - a mesh file that is known to be whole, in the form that Assimp is given.
//
// Assimp reads damaged files without a word, or crashes on them. So each format has a check that
// walks the whole file first, says what is wrong and where, and leaves only what makes triangles:
// no comments, no names, no unknown elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// The triangles from `first_triangle` to the next run's have this material.
struct MaterialRun {
    std::size_t first_triangle = 0;
    std::uint32_t material = 0; // into CheckedMesh::materials
};

struct CheckedMesh {
    std::string bytes;                       // for Assimp, the same format as the file
    std::size_t triangle_count = 0;          // a face of n corners is n - 2 triangles; at least 1
    std::vector<std::string> materials;      // names, in order of first use; empty: no materials
    std::vector<MaterialRun> material_runs;  // by triangle
    std::vector<std::string> material_files; // as written in the file
    std::vector<std::string> warnings;
};

/// A face has at most this many corners: Assimp copies a line into a buffer of 1 MB.
inline constexpr std::int64_t kMaxCorners = 65536;

/// Triangle ids stay below kNoItem, and a triangle may bring three vertices with it.
inline constexpr std::size_t kMaxFileTriangles = 0x50000000;

/// Check a file's bytes.
///
/// name    of the file, for messages
/// throws  FileError, SceneError: names the file and the line, or the facet, vertex or face (all
///         counted from 0, lines from 1)
CheckedMesh check_ply(std::string bytes, const std::string& name);
CheckedMesh check_stl(std::string bytes, const std::string& name);
CheckedMesh check_obj(std::string bytes, const std::string& name);

/// Appends a number in a form that Assimp reads right, and a blank. It reads 16 digits without an
/// exponent well, but overflows on many digits.
///
/// word   as it stands in the file
/// value  what it means
void append_number(std::string& out, std::string_view word, float value);
void append_integer(std::string& out, std::int64_t value);

/// Warns about faces with fewer than three corners, which are left out.
void warn_thin_faces(
    std::size_t count, const std::string& name, std::vector<std::string>& warnings);

/// throws  FileError where there is none, or more than kMaxFileTriangles
void check_triangle_count(std::size_t count, const std::string& name);

} // namespace firsthit
