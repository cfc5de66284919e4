// raw_mesh.cpp - what the readers of all mesh formats share.
#include "readers/mesh/raw_mesh.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit {

void warn_thin_faces(std::size_t count, const std::string& name, std::vector<std::string>& warnings)
{
    if (count > 0)
        warnings.push_back(
            fmt::format("{}: {} faces with fewer than 3 corners are left out", name, count));
}

void check_triangle_count(std::size_t count, const std::string& name)
{
    if (count == 0) throw FileError(fmt::format("{}: no triangles in it", name));
    if (count > kMaxFileTriangles)
        throw FileError(fmt::format(
            "{}: {} triangles, at most {} are accepted", name, count, kMaxFileTriangles));
}

} // namespace firsthit
