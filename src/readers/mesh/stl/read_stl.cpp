// read_stl.cpp - STL files: chooses between binary and text, and reads binary ones.
#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/stl/stl_colors.h"
#include "readers/mesh/stl/stl_text.h"
#include "base/large_pages.h"
#include "base/reserve_large.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace firsthit {
namespace {

constexpr std::size_t kHeader = 84; // 80 bytes of anything, then the number of facets
constexpr std::size_t kFacet = 50;  // normal, three corners, 2 bytes of anything

std::size_t facet_count(const std::string& bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

/// Whether a facet's numbers could be those of a mesh: finite and neither huge nor tiny, with a normal
/// that is unit or zero. Bytes of anything else hardly ever are.
bool is_plausible(const char* facet)
{
    std::array<float, 12> number;
    std::memcpy(number.data(), facet, sizeof number);
    const bool in_range = std::all_of(number.begin(), number.end(), [](float x) {
        const float size = std::abs(x);
        return x == 0.0f || (1e-20f < size && size < 1e20f);
    });
    const float length = std::hypot(number[0], number[1], number[2]);
    return in_range && (length == 0.0f || (0.9f < length && length < 1.1f));
}

/// How many facets a binary file has: what its header says, or what its length says where the header
/// is wrong.
/// throws  FileError where the two differ and the bytes do not look like facets
std::size_t count_facets(const std::string& bytes, const std::string& name, Problems& problems)
{
    const std::size_t said = facet_count(bytes);
    const std::size_t room = (bytes.size() - kHeader) / kFacet;
    const std::size_t spare = (bytes.size() - kHeader) % kFacet;
    if (said == room && spare == 0) return said;

    // Bytes of something else may stand behind as many facets as the header says.
    const bool appended = 0 < said && said < room && spare != 0;
    const std::size_t count = said == room || appended ? said : room;
    const std::size_t looked_at = std::min<std::size_t>(count, 100);
    std::size_t plausible = 0;
    for (std::size_t f = 0; f < looked_at; ++f)
        plausible += is_plausible(bytes.data() + kHeader + f * kFacet);
    if (2 * plausible < looked_at || count == 0)
        throw FileError(
            fmt::format("{}: the header says {} facets, which makes {} bytes; the file has {}",
                name, said, kHeader + kFacet * said, bytes.size()));
    if (count != said)
        problems.add(
            fmt::format("the header says {} facets, but the file's length makes {}: these are read",
                said, room));
    if (const std::size_t rest = bytes.size() - kHeader - count * kFacet; rest > 0)
        problems.add(fmt::format("{} bytes behind the last facet are left out", rest));
    return count;
}

RawMesh read_binary(const std::string& bytes, const std::string& name)
{
    RawMesh mesh;
    const std::size_t count = count_facets(bytes, name, mesh.problems);
    check_triangle_count(count, name);
    resize_in_large_pages(mesh.position, count * 3);
    reserve_in_large_pages(mesh.index, count);

    // The normals are not used.
    const char* facet = bytes.data() + kHeader;
    for (std::size_t f = 0; f < count; ++f, facet += kFacet) {
        static_assert(sizeof(glm::vec3) == 12);
        std::memcpy(&mesh.position[3 * f], facet + 12, 36);
        const auto first = static_cast<std::uint32_t>(3 * f);
        mesh.index.emplace_back(first, first + 1, first + 2);
    }
    mesh.triangle_color = stl_colors(bytes.data(), bytes.data() + kHeader, count);
    return mesh;
}

} // namespace

RawMesh read_stl(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    const bool exact =
        bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facet_count(bytes);
    if (!exact && is_stl_text(bytes)) return read_stl_text(bytes, name);
    if (!exact && (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")))
        throw FileError(fmt::format("{}: the text is UTF-16; ASCII and UTF-8 are accepted", name));
    if (bytes.size() < kHeader)
        throw FileError(
            fmt::format("{}: {} bytes, neither 'solid' nor the {} bytes of a binary header", name,
                bytes.size(), kHeader));
    return read_binary(bytes, name);
}

} // namespace firsthit
