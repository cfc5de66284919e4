// checked_mesh.cpp - what the checks of all mesh formats share.
#include "readers/mesh/checked_mesh.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <charconv>

namespace firsthit {

void append_number(std::string& out, std::string_view word, float value)
{
    if (word.size() <= 16 && word.find_first_of("+eE") == std::string_view::npos) {
        out.append(word);
    } else {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
        out.append(digits, end);
    }
    out.push_back(' ');
}

void append_integer(std::string& out, std::int64_t value)
{
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out.append(digits, end);
    out.push_back(' ');
}

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
