// stl_check.cpp - is an STL file whole?
#include "readers/mesh/checked_mesh.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <utility>

namespace firsthit {
namespace {

constexpr std::size_t kHeader = 84; // 80 bytes of anything, then the number of facets
constexpr std::size_t kFacet = 50;  // normal, three corners, 2 bytes of anything

std::uint32_t facet_count(const std::string& bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

bool is_binary_size(const std::string& bytes)
{
    return bytes.size() >= kHeader &&
           bytes.size() == kHeader + kFacet * std::size_t(facet_count(bytes));
}

bool same_word(std::string_view word, std::string_view lower)
{
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
        [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// Exporters write "solid" into binary headers too, so a text must also be free of zeros.
bool looks_like_text(const std::string& bytes)
{
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string::npos &&
           same_word(std::string_view(bytes).substr(first, 5), "solid") &&
           bytes.find('\0') == std::string::npos;
}

CheckedMesh check_binary(std::string bytes, const std::string& name)
{
    CheckedMesh mesh;
    mesh.triangle_count = facet_count(bytes);
    check_triangle_count(mesh.triangle_count, name);

    // Corners must be finite; the normals are not used.
    const char* facet = bytes.data() + kHeader;
    for (std::size_t f = 0; f < mesh.triangle_count; ++f, facet += kFacet) {
        float corner[9];
        std::memcpy(corner, facet + 12, sizeof corner);
        float sum = 0;
        for (const float c : corner) sum += c * 0.0f; // not zero where one is not finite
        if (sum != 0.0f || std::isnan(sum)) {
            const auto bad = std::find_if_not(
                std::begin(corner), std::end(corner), [](float c) { return std::isfinite(c); });
            const auto place = bad - std::begin(corner);
            throw SceneError(fmt::format("{}: facet {}, corner {}: {} is {}, not a finite number",
                name, f, place / 3, "xyz"[place % 3], *bad));
        }
    }

    // Assimp takes a file that begins with "solid" for a text where its size is odd.
    std::fill_n(bytes.begin(), 80, ' ');
    mesh.bytes = std::move(bytes);
    return mesh;
}

CheckedMesh check_text(const std::string& bytes, const std::string& name)
{
    CheckedMesh mesh;
    mesh.bytes = "solid s\n";
    TextCursor text(bytes, name);

    enum class In { file, solid, facet, loop, closed_loop };
    In in = In::file;
    int corners = 0;
    while (text.next_line()) {
        const std::string_view word = text.next_word();
        const auto expect = [&](In state) {
            if (in != state)
                text.fail(fmt::format("'{}' stands at the wrong place", printable(word)));
        };
        if (word.empty()) continue;
        if (same_word(word, "vertex")) {
            expect(In::loop);
            if (++corners > 3) text.fail("a facet has more than 3 vertices");
            mesh.bytes += "vertex ";
            for (const char* const axis : {"x", "y", "z"}) {
                const float value = text.number(axis);
                append_number(mesh.bytes, text.word(), value);
            }
            text.expect_end();
            mesh.bytes.back() = '\n';
        } else if (same_word(word, "facet")) {
            expect(In::solid);
            in = In::facet;
            // Exporters write normals that are no numbers; they are not used.
            mesh.bytes += "facet normal 0 0 0\nouter loop\n";
        } else if (same_word(word, "outer")) {
            expect(In::facet);
            in = In::loop;
            corners = 0;
        } else if (same_word(word, "endloop")) {
            expect(In::loop);
            if (corners != 3)
                text.fail(fmt::format("a facet has {} vertices, 3 are needed", corners));
            in = In::closed_loop;
        } else if (same_word(word, "endfacet")) {
            expect(In::closed_loop);
            in = In::solid;
            ++mesh.triangle_count;
            mesh.bytes += "endloop\nendfacet\n";
        } else if (same_word(word, "endsolid")) {
            expect(In::solid);
            in = In::file;
        } else if (same_word(word, "solid")) {
            expect(In::file);
            in = In::solid;
        } else {
            text.fail(fmt::format("'{}' is no word of an STL file", printable(word)));
        }
    }
    if (in != In::file) text.fail("the file ends inside a solid: it is truncated");
    check_triangle_count(mesh.triangle_count, name);
    mesh.bytes += "endsolid s\n";
    return mesh;
}

} // namespace

CheckedMesh check_stl(std::string bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    if (is_binary_size(bytes)) return check_binary(std::move(bytes), name);
    if (looks_like_text(bytes)) return check_text(bytes, name);
    if (bytes.size() < kHeader)
        throw FileError(
            fmt::format("{}: {} bytes, neither 'solid' nor the {} bytes of a binary header", name,
                bytes.size(), kHeader));
    throw FileError(
        fmt::format("{}: the header says {} facets, which makes {} bytes; the file has {}", name,
            facet_count(bytes), kHeader + kFacet * std::size_t(facet_count(bytes)), bytes.size()));
}

} // namespace firsthit
