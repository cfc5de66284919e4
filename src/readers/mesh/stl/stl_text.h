// stl_text.h - STL files that are text.
#pragma once

#include "readers/mesh/raw_mesh.h"

#include <string>

namespace firsthit {

/// Whether a file is text: its first word is "solid" or "facet", behind a byte order mark or not, and
/// no zero is among its first bytes. Exporters write "solid" into binary headers too.
bool is_stl_text(const std::string& bytes);

/// Reads a text word by word; solids are runs. What is not complete, and words that nobody knows, are
/// left out with a problem.
/// throws  FileError: no triangles, a coordinate that is no number (names the line)
RawMesh read_stl_text(const std::string& bytes, const std::string& name);

} // namespace firsthit
