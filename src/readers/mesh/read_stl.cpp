// read_stl.cpp - STL files, binary and ascii.
#include "readers/mesh/raw_mesh.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

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

RawMesh read_binary(const std::string& bytes, const std::string& name)
{
    const std::size_t count = facet_count(bytes);
    check_triangle_count(count, name);
    RawMesh mesh;
    mesh.position.resize(count * 3);
    mesh.index.reserve(count);

    // Corners must be finite; the normals are not used.
    const char* facet = bytes.data() + kHeader;
    for (std::size_t f = 0; f < count; ++f, facet += kFacet) {
        float corner[9];
        std::memcpy(corner, facet + 12, sizeof corner);
        for (std::size_t k = 0; k < 3; ++k)
            mesh.position[3 * f + k] = {corner[3 * k], corner[3 * k + 1], corner[3 * k + 2]};
        const auto first = static_cast<std::uint32_t>(3 * f);
        mesh.index.emplace_back(first, first + 1, first + 2);
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
    return mesh;
}

RawMesh read_text(const std::string& bytes, const std::string& name)
{
    RawMesh mesh;
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
            glm::vec3& position = mesh.position.emplace_back();
            position.x = text.number("x");
            position.y = text.number("y");
            position.z = text.number("z");
            text.expect_end();
        } else if (same_word(word, "facet")) {
            expect(In::solid);
            in = In::facet; // exporters write normals that are no numbers; they are not used
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
            const auto first = static_cast<std::uint32_t>(mesh.position.size() - 3);
            mesh.index.emplace_back(first, first + 1, first + 2);
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
    check_triangle_count(mesh.index.size(), name);
    return mesh;
}

} // namespace

RawMesh read_stl(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    if (is_binary_size(bytes)) return read_binary(bytes, name);
    if (looks_like_text(bytes)) return read_text(bytes, name);
    if (bytes.size() < kHeader)
        throw FileError(
            fmt::format("{}: {} bytes, neither 'solid' nor the {} bytes of a binary header", name,
                bytes.size(), kHeader));
    throw FileError(
        fmt::format("{}: the header says {} facets, which makes {} bytes; the file has {}", name,
            facet_count(bytes), kHeader + kFacet * std::size_t(facet_count(bytes)), bytes.size()));
}

} // namespace firsthit
