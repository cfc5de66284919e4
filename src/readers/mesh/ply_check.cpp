// ply_check.cpp - is a PLY file whole? Leaves the elements vertex and face.
//
// source  Turk 1994, "The PLY Polygon File Format"
#include "readers/mesh/checked_mesh.h"
#include "readers/mesh/ply_header.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace firsthit {
namespace {

void check_finite(
    double value, std::size_t vertex, const PlyProperty& property, const std::string& name)
{
    if (!std::isfinite(static_cast<float>(value)))
        throw SceneError(fmt::format(
            "{}: vertex {}: {} is {}, not a finite float", name, vertex, property.name, value));
}

void check_index(
    std::int64_t index, std::size_t vertices, std::size_t face, const std::string& name)
{
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
        throw SceneError(fmt::format(
            "{}: face {}: index {} is out of range ({} vertices)", name, face, index, vertices));
}

/// returns  the triangles that a face of that many corners makes
std::size_t check_corners(std::int64_t corners, std::size_t face, const std::string& name)
{
    if (corners < 0 || corners > kMaxCorners)
        throw FileError(fmt::format(
            "{}: face {}: {} corners, 0 to {} are accepted", name, face, corners, kMaxCorners));
    return corners < 3 ? 0 : static_cast<std::size_t>(corners) - 2;
}

// Assimp skips blanks and line ends after a header, even where they are a binary file's first
// bytes.
constexpr char kPad = 'x';

/// Writes the header that Assimp is given: of two elements, with the properties it should look at.
///
/// unused  keep the other properties as well, and put one byte of padding in front
std::string written_header(const PlyHeader& header, const char* format, bool unused)
{
    std::string out = fmt::format("ply\nformat {} 1.0\n", format);
    if (unused) out += "element edge 1\nproperty uchar unused\n";
    for (const PlyElement* const element : {&header.vertex, &header.face}) {
        out += fmt::format("element {} {}\n", element->name, element->count);
        for (const PlyProperty& property : element->properties) {
            if (!property.used && !unused) continue;
            const std::string_view shown =
                property.used ? std::string_view(property.name) : "unused";
            if (property.is_list)
                out += fmt::format("property list {} {} {}\n", ply_type_name(property.count_type),
                    ply_type_name(property.type), shown);
            else
                out += fmt::format("property {} {}\n", ply_type_name(property.type), shown);
        }
    }
    return out + "end_header\n";
}

/// Walks the body of a binary file. It needs no copy: unknown properties stay, under another name.
class BinaryBody {
  public:
    BinaryBody(std::string_view body, bool big_endian, const std::string& name)
        : body_(body),
          big_endian_(big_endian),
          name_(name)
    {
    }

    void check_vertices(const PlyElement& vertex)
    {
        for (std::size_t v = 0; v < vertex.count; ++v)
            for (const PlyProperty& property : vertex.properties) {
                const double value = take(property.type, "vertex", v);
                if (property.used) check_finite(value, v, property, name_);
            }
    }

    std::size_t check_faces(const PlyElement& face, std::size_t vertices, std::size_t& thin)
    {
        std::size_t triangles = 0;
        for (std::size_t f = 0; f < face.count; ++f)
            for (const PlyProperty& property : face.properties) {
                const auto items = property.is_list ? static_cast<std::int64_t>(
                                                          take(property.count_type, "face", f))
                                                    : 1;
                if (property.is_list) {
                    const std::size_t made = check_corners(items, f, name_);
                    if (property.used) triangles += made;
                    if (property.used && made == 0) ++thin;
                }
                for (std::int64_t i = 0; i < items; ++i) {
                    const double value = take(property.type, "face", f);
                    if (property.used)
                        check_index(static_cast<std::int64_t>(value), vertices, f, name_);
                }
            }
        return triangles;
    }

    std::size_t consumed() const { return at_; }

  private:
    double take(PlyType type, const char* element, std::size_t number)
    {
        const std::size_t size = ply_type_size(type);
        if (body_.size() - at_ < size)
            throw FileError(
                fmt::format("{}: the file ends at {} {}: it is truncated", name_, element, number));
        const double value = ply_value(body_.data() + at_, type, big_endian_);
        at_ += size;
        return value;
    }

    std::string_view body_;
    bool big_endian_;
    const std::string& name_;
    std::size_t at_ = 0;
};

/// Rewrites the body of an ascii file with one element a line.
class TextBody {
  public:
    TextBody(
        std::string_view body, std::size_t lines_before, const std::string& name, std::string& out)
        : text_(body, name),
          out_(out)
    {
        text_.start_after(lines_before);
    }

    void copy_vertices(const PlyElement& vertex)
    {
        for (std::size_t v = 0; v < vertex.count; ++v) {
            start("vertex", v);
            for (const PlyProperty& property : vertex.properties) {
                const float value = text_.number(property.name);
                if (property.used) append_number(out_, text_.word(), value);
            }
            text_.expect_end();
            out_.back() = '\n';
        }
    }

    std::size_t copy_faces(const PlyElement& face, std::size_t vertices, std::size_t& thin)
    {
        std::size_t triangles = 0;
        for (std::size_t f = 0; f < face.count; ++f) {
            start("face", f);
            for (const PlyProperty& property : face.properties) {
                if (property.used)
                    triangles += copy_corners(f, vertices, thin);
                else
                    skip(property, f);
            }
            text_.expect_end();
            out_.back() = '\n';
        }
        return triangles;
    }

  private:
    void start(const char* element, std::size_t number)
    {
        do {
            if (!text_.next_line())
                throw FileError(fmt::format(
                    "{}: the file ends at {} {}: it is truncated", text_.name(), element, number));
        } while (!text_.has_word());
    }

    std::size_t copy_corners(std::size_t face, std::size_t vertices, std::size_t& thin)
    {
        const std::int64_t corners = text_.integer("the number of corners");
        const std::size_t triangles = check_corners(corners, face, text_.name());
        if (triangles == 0) ++thin;
        append_integer(out_, corners);
        for (std::int64_t c = 0; c < corners; ++c) {
            const std::int64_t index = text_.integer("a vertex index");
            if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
                throw SceneError(
                    fmt::format("{}:{}: face {}: index {} is out of range ({} vertices)",
                        text_.name(), text_.line(), face, index, vertices));
            append_integer(out_, index);
        }
        return triangles;
    }

    void skip(const PlyProperty& property, std::size_t face)
    {
        std::int64_t items = 1;
        if (property.is_list) {
            items = text_.integer("the length of a list");
            check_corners(items, face, text_.name());
        }
        for (std::int64_t i = 0; i < items; ++i) text_.number(property.name);
    }

    TextCursor text_;
    std::string& out_;
};

} // namespace

CheckedMesh check_ply(std::string bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    const PlyHeader header = read_ply_header(bytes, name);
    const std::string_view body = std::string_view(bytes).substr(header.size);

    // Every element takes a byte or more, so that counts beyond the file's size are known at once.
    for (const PlyElement* const element : {&header.vertex, &header.face})
        if (element->count > body.size())
            throw FileError(fmt::format("{}: the header says {} elements '{}', but only {} bytes "
                                        "follow it: the file is truncated",
                name, element->count, element->name, body.size()));

    CheckedMesh mesh;
    std::size_t thin = 0;
    if (header.format == PlyFormat::ascii) {
        mesh.bytes = written_header(header, "ascii", false);
        mesh.bytes.reserve(mesh.bytes.size() + body.size());
        TextBody text(body, header.lines, name, mesh.bytes);
        text.copy_vertices(header.vertex);
        mesh.triangle_count = text.copy_faces(header.face, header.vertex.count, thin);
    } else {
        const bool big_endian = header.format == PlyFormat::big_endian;
        BinaryBody binary(body, big_endian, name);
        binary.check_vertices(header.vertex);
        mesh.triangle_count = binary.check_faces(header.face, header.vertex.count, thin);
        mesh.bytes =
            written_header(header, big_endian ? "binary_big_endian" : "binary_little_endian", true);
        mesh.bytes.reserve(mesh.bytes.size() + 1 + binary.consumed());
        mesh.bytes += kPad;
        mesh.bytes += body.substr(0, binary.consumed());
    }
    warn_thin_faces(thin, name, mesh.warnings);
    check_triangle_count(mesh.triangle_count, name);
    return mesh;
}

} // namespace firsthit
