// read_ply.cpp - PLY files: the elements vertex and face.
//
// source  Turk 1994, "The PLY Polygon File Format"
#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/ply_header.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

void check_index(
    std::int64_t index, std::size_t vertices, std::size_t face, const std::string& name)
{
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
        throw SceneError(fmt::format(
            "{}: face {}: index {} is out of range ({} vertices)", name, face, index, vertices));
}

void check_corners(std::int64_t corners, std::size_t face, const std::string& name)
{
    if (corners < 0 || corners > kMaxCorners)
        throw FileError(fmt::format(
            "{}: face {}: {} corners, 0 to {} are accepted", name, face, corners, kMaxCorners));
}

/// Where a vertex keeps the value of each property.
enum class Slot { none, x, y, z, nx, ny, nz, u, v };

Slot slot_of(const PlyProperty& property)
{
    static constexpr std::pair<std::string_view, Slot> kSlots[] = {{"x", Slot::x}, {"y", Slot::y},
        {"z", Slot::z}, {"nx", Slot::nx}, {"ny", Slot::ny}, {"nz", Slot::nz}, {"u", Slot::u},
        {"s", Slot::u}, {"texture_u", Slot::u}, {"v", Slot::v}, {"t", Slot::v},
        {"texture_v", Slot::v}};
    if (property.used)
        for (const auto& [name, slot] : kSlots)
            if (property.name == name) return slot;
    return Slot::none;
}

/// Takes the values of vertices, property by property, and the corners of faces.
class Maker {
  public:
    Maker(const PlyElement& vertex, RawMesh& mesh) : mesh_(mesh)
    {
        for (const PlyProperty& property : vertex.properties) slots_.push_back(slot_of(property));
        const auto has = [&](Slot slot) {
            return std::find(slots_.begin(), slots_.end(), slot) != slots_.end();
        };
        mesh.position.resize(vertex.count);
        if (has(Slot::nx)) mesh.normal.resize(vertex.count);
        if (has(Slot::u)) mesh.uv.resize(vertex.count);
    }

    void set(std::size_t vertex, std::size_t property, float value)
    {
        const Slot slot = slots_[property];
        const auto axis = [&](Slot first) {
            return static_cast<int>(slot) - static_cast<int>(first);
        };
        if (slot >= Slot::u)
            mesh_.uv[vertex][axis(Slot::u)] = value;
        else if (slot >= Slot::nx)
            mesh_.normal[vertex][axis(Slot::nx)] = value;
        else if (slot >= Slot::x)
            mesh_.position[vertex][axis(Slot::x)] = value;
    }

    /// Corner number k of a face.
    void add_corner(std::int64_t k, std::int64_t index)
    {
        const auto vertex = static_cast<std::uint32_t>(index);
        if (k == 0)
            first_ = vertex;
        else if (k > 1)
            mesh_.index.emplace_back(first_, last_, vertex);
        last_ = vertex;
    }

  private:
    RawMesh& mesh_;
    std::vector<Slot> slots_; // of the vertex's properties
    std::uint32_t first_ = 0, last_ = 0;
};

class BinaryBody {
  public:
    BinaryBody(std::string_view body, bool big_endian, const std::string& name, Maker& maker)
        : body_(body),
          big_endian_(big_endian),
          name_(name),
          maker_(maker)
    {
    }

    void read_vertices(const PlyElement& vertex)
    {
        for (std::size_t v = 0; v < vertex.count; ++v)
            for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
                const PlyProperty& property = vertex.properties[p];
                const double value = take(property.type, "vertex", v);
                if (!property.used) continue;
                const auto rounded = static_cast<float>(value);
                if (!std::isfinite(rounded))
                    throw SceneError(fmt::format("{}: vertex {}: {} is {}, not a finite float",
                        name_, v, property.name, value));
                maker_.set(v, p, rounded);
            }
    }

    /// returns  how many have fewer than three corners
    std::size_t read_faces(const PlyElement& face, std::size_t vertices)
    {
        std::size_t thin = 0;
        for (std::size_t f = 0; f < face.count; ++f)
            for (const PlyProperty& property : face.properties) {
                const auto items = property.is_list ? static_cast<std::int64_t>(
                                                          take(property.count_type, "face", f))
                                                    : 1;
                if (property.is_list) check_corners(items, f, name_);
                if (property.used && items < 3) ++thin;
                for (std::int64_t i = 0; i < items; ++i) {
                    const double value = take(property.type, "face", f);
                    if (!property.used) continue;
                    const auto index = static_cast<std::int64_t>(value);
                    check_index(index, vertices, f, name_);
                    maker_.add_corner(i, index);
                }
            }
        return thin;
    }

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
    Maker& maker_;
    std::size_t at_ = 0;
};

/// Has one element a line.
class TextBody {
  public:
    TextBody(std::string_view body, std::size_t lines_before, const std::string& name, Maker& maker)
        : text_(body, name),
          maker_(maker)
    {
        text_.start_after(lines_before);
    }

    void read_vertices(const PlyElement& vertex)
    {
        for (std::size_t v = 0; v < vertex.count; ++v) {
            start("vertex", v);
            for (std::size_t p = 0; p < vertex.properties.size(); ++p)
                maker_.set(v, p, text_.number(vertex.properties[p].name));
            text_.expect_end();
        }
    }

    /// returns  how many have fewer than three corners
    std::size_t read_faces(const PlyElement& face, std::size_t vertices)
    {
        std::size_t thin = 0;
        for (std::size_t f = 0; f < face.count; ++f) {
            start("face", f);
            for (const PlyProperty& property : face.properties) {
                if (!property.used)
                    skip(property, f);
                else if (read_corners(f, vertices) < 3)
                    ++thin;
            }
            text_.expect_end();
        }
        return thin;
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

    std::int64_t read_corners(std::size_t face, std::size_t vertices)
    {
        const std::int64_t corners = text_.integer("the number of corners");
        check_corners(corners, face, text_.name());
        for (std::int64_t c = 0; c < corners; ++c) {
            const std::int64_t index = text_.integer("a vertex index");
            if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
                throw SceneError(
                    fmt::format("{}:{}: face {}: index {} is out of range ({} vertices)",
                        text_.name(), text_.line(), face, index, vertices));
            maker_.add_corner(c, index);
        }
        return corners;
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
    Maker& maker_;
};

} // namespace

RawMesh read_ply(const std::string& bytes, const std::string& name)
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

    RawMesh mesh;
    Maker maker(header.vertex, mesh);
    std::size_t thin = 0;
    const auto read = [&](auto body_reader) {
        body_reader.read_vertices(header.vertex);
        thin = body_reader.read_faces(header.face, header.vertex.count);
    };
    if (header.format == PlyFormat::ascii)
        read(TextBody(body, header.lines, name, maker));
    else
        read(BinaryBody(body, header.format == PlyFormat::big_endian, name, maker));
    warn_thin_faces(thin, name, mesh.warnings);
    check_triangle_count(mesh.index.size(), name);
    return mesh;
}

} // namespace firsthit
