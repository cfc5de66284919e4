// read_ply.cpp - PLY files: vertices, and faces or strips.
//
// source  Turk 1994, "The PLY Polygon File Format"
#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/ply/ply_color.h"
#include "readers/mesh/ply/ply_elements.h"
#include "readers/mesh/ply/ply_header.h"
#include "readers/mesh/ply/ply_lines.h"
#include "base/large_pages.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firsthit {
namespace {

constexpr std::size_t kGrain = 1 << 15; // vertices that one thread takes at once

/// The fewest bytes of an element.
std::size_t least_bytes(const PlyElement& element, bool text)
{
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += text ? 1 : ply_type_size(property.is_list ? property.count_type : property.type);
    return std::max<std::size_t>(1, bytes);
}

class PlyReader {
  public:
    PlyReader(const std::string& bytes, const std::string& name, Tasks& tasks)
        : name_(name),
          tasks_(tasks),
          header_(read_ply_header(bytes, name, mesh_.problems)),
          body_(std::string_view(bytes).substr(header_.size))
    {
    }

    RawMesh read()
    {
        if (header_.vertex()->count == 0) check_triangle_count(0, name_);
        if (!header_.faces())
            throw FileError(
                fmt::format("{}: no triangles in it: it is a cloud of {} points without "
                            "faces",
                    name_, header_.vertex()->count));
        make_columns();
        if (header_.format == PlyFormat::ascii) {
            PlyWords words(body_, header_.lines, name_);
            read_elements(words, read_lines(words));
            if (!ends_ && words.has_more())
                mesh_.problems.add("there are words behind the last element", "byte",
                    header_.size + words.consumed());
        } else {
            PlyBytes binary(body_, header_.format == PlyFormat::big_endian, name_);
            read_elements(binary, 0);
            if (!ends_) check_rest(body_.substr(binary.consumed()));
        }
        append_triangles(parts_, mesh_);
        finish();
        return std::move(mesh_);
    }

  private:
    /// Makes room for the vertices, no more than the file can have.
    void make_columns()
    {
        const PlyElement& vertex = *header_.vertex();
        const bool text = header_.format == PlyFormat::ascii;
        vertices_ = std::min(vertex.count, body_.size() / least_bytes(vertex, text) + 1);
        resize_in_large_pages(mesh_.position, vertices_);
        if (vertex.has(PlyRole::nx)) mesh_.normal.resize(vertices_);
        if (vertex.has(PlyRole::u)) mesh_.uv.resize(vertices_);
        if (vertex.has(PlyRole::red)) mesh_.color.resize(vertices_);
        for (const PlyProperty& property : vertex.properties) {
            PlyColumn column{.type = property.type,
                .is_list = property.is_list,
                .count_type = property.count_type};
            const auto use = [&](auto& values, PlyRole first) {
                column.to = &values[0][int(property.role) - int(first)];
                column.stride = sizeof(values[0]) / sizeof(float);
            };
            if (property.role == PlyRole::none || vertices_ == 0)
                column.to = nullptr;
            else if (property.role >= PlyRole::red)
                use(mesh_.color, PlyRole::red);
            else if (property.role >= PlyRole::u)
                use(mesh_.uv, PlyRole::u);
            else if (property.role >= PlyRole::nx)
                use(mesh_.normal, PlyRole::nx);
            else
                use(mesh_.position, PlyRole::x);
            columns_.push_back(column);
        }
    }

    /// Reads vertices and faces by several threads, if the text allows it.
    /// returns  how many elements it has read
    std::size_t read_lines(PlyWords& words)
    {
        const std::vector<PlyElement>& elements = header_.elements;
        if (elements.size() < 2 || elements[0].kind != PlyElement::Kind::vertex ||
            elements[1].kind != PlyElement::Kind::faces || vertices_ != elements[0].count)
            return 0;
        const auto size = read_ply_lines(
            body_, {elements[0], elements[1], mesh_.position, columns_}, parts_, tasks_);
        if (!size) return 0;
        vertices_read_ = true;
        words.seek(*size);
        return 2;
    }

    /// Reads the elements from number `first` on, in the file's order, but faces behind the vertices.
    template <class Source>
    void read_elements(Source& source, std::size_t first)
    {
        std::vector<std::pair<const PlyElement*, std::size_t>> early; // faces, and where they begin
        for (std::size_t e = first; e < header_.elements.size() && !ends_; ++e) {
            const PlyElement& element = header_.elements[e];
            if (element.kind == PlyElement::Kind::other) {
                skip(source, element);
            } else if (element.kind == PlyElement::Kind::vertex) {
                read_vertices(source, element);
            } else if (vertices_read_) {
                read_triangles(source, element);
            } else {
                early.emplace_back(&element, source.consumed());
                skip(source, element);
            }
        }
        if (early.empty()) return;
        const std::size_t end = source.consumed();
        for (const auto& [element, place] : early) {
            source.seek(place);
            read_triangles(source, *element);
        }
        source.seek(end);
    }

    /// Calls read(number) for all elements, until the file ends.
    /// returns  how many there are
    template <class Read>
    std::size_t read_each(const PlyElement& element, std::size_t first, const Read& read)
    {
        std::size_t number = first;
        try {
            for (; number < element.count; ++number) read(number);
        } catch (const PlyFileEnds&) {
            if (!ends_)
                end_ = fmt::format(
                    "the file ends at {} {} of {}", printable(element.name), number, element.count);
            ends_ = true;
        }
        return number;
    }

    template <class Source>
    void skip(Source& source, const PlyElement& element)
    {
        // Nothing to read would take for ever.
        if (element.properties.empty()) return;
        read_each(element, 0, [&](std::size_t) {
            for (const PlyProperty& property : element.properties) skip_property(source, property);
        });
    }

    template <class Source>
    void read_vertices(Source& source, const PlyElement& vertex)
    {
        vertices_read_ = true;
        std::size_t done = 0;
        if constexpr (std::is_same_v<Source, PlyBytes>) done = read_fixed_vertices(source, vertex);
        done = read_each(vertex, done, [&](std::size_t v) {
            if (v == vertices_) throw PlyFileEnds();
            read_vertex(source, columns_, v);
        });
        vertices_ = std::min(vertices_, done);
    }

    /// Vertices that have no lists, by several threads.
    std::size_t read_fixed_vertices(PlyBytes& source, const PlyElement& vertex)
    {
        if (vertex.has_list()) return 0;
        const std::size_t size = least_bytes(vertex, false);
        const std::size_t begin = source.consumed();
        const std::size_t count = std::min(vertices_, (body_.size() - begin) / size);
        tasks_.for_ranges(count, kGrain, [&](std::size_t first, std::size_t last) {
            PlyBytes part = source;
            part.seek(begin + first * size);
            for (std::size_t v = first; v < last; ++v) read_vertex(part, columns_, v);
        });
        source.seek(begin + count * size);
        return count;
    }

    template <class Source>
    void read_triangles(Source& source, const PlyElement& element)
    {
        const PlyFaceElement of{element, vertices_};
        PlyTriangleMaker maker(std::span(mesh_.position).first(vertices_),
            element.has(PlyRole::texcoord), element.has(PlyRole::red));
        if (element.kind == PlyElement::Kind::strips) {
            std::vector<std::int64_t> strip;
            read_each(element, 0, [&](std::size_t number) {
                read_strip(source, of, number, strip);
                maker.add_strip(strip);
            });
        } else {
            PlyFace face;
            read_each(element, 0, [&](std::size_t number) {
                read_face(source, of, number, face);
                maker.add(face, number);
            });
        }
        parts_.push_back(std::move(maker.triangles));
    }

    void check_rest(std::string_view rest)
    {
        if (std::any_of(rest.begin(), rest.end(), [](char c) { return !is_word_end(c); }))
            mesh_.problems.add(
                fmt::format("{} bytes behind the last element are left out", rest.size()));
    }

    void finish()
    {
        if (mesh_.index.empty() && ends_)
            throw FileError(
                fmt::format("{}: {}: it is truncated, and has no triangles", name_, end_));
        check_triangle_count(mesh_.index.size(), name_);
        if (ends_) mesh_.problems.add(fmt::format("{}: the rest is missing", end_));

        make_colors_linear(mesh_.color, *header_.vertex());
        for (const PlyElement& element : header_.elements)
            if (element.kind == PlyElement::Kind::faces)
                make_colors_linear(mesh_.triangle_color, element);
        if (!header_.textures.empty()) mesh_.texture = header_.textures.front();
        if (header_.textures.size() > 1)
            mesh_.problems.add(fmt::format(
                "of {} textures the first is used for all faces", header_.textures.size()));
    }

    void make_colors_linear(std::vector<glm::vec4>& colors, const PlyElement& element)
    {
        if (colors.empty()) return;
        std::vector<std::size_t> not_finite((colors.size() + kGrain - 1) / kGrain);
        tasks_.for_ranges(colors.size(), kGrain, [&](std::size_t first, std::size_t last) {
            not_finite[first / kGrain] =
                make_linear(std::span(colors).subspan(first, last - first), element);
        });
        std::size_t sum = 0;
        for (const std::size_t count : not_finite) sum += count;
        mesh_.problems.add_times("colours that are not finite are taken as white", sum);
    }

    const std::string& name_;
    Tasks& tasks_;
    RawMesh mesh_;
    PlyHeader header_;
    std::string_view body_;
    std::vector<PlyColumn> columns_;
    std::vector<PlyTriangles> parts_;
    std::size_t vertices_ = 0; // that there is room for; when they were read, those that are there
    bool vertices_read_ = false;
    bool ends_ = false; // before all elements were read
    std::string end_;   // where
};

} // namespace

RawMesh read_ply(const std::string& bytes, const std::string& name, Tasks& tasks)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return PlyReader(bytes, name, tasks).read();
}

} // namespace firsthit
