// ply_elements.h - reads vertices and faces of a PLY file from any source of ply_sources.h.
#pragma once

#include "readers/mesh/ply/ply_faces.h"
#include "readers/mesh/ply/ply_sources.h"

#include <cstddef>
#include <string>
#include <vector>

namespace firsthit {

/// Where the values of a vertex go, property by property.
struct PlyColumn {
    float* to = nullptr;    // of vertex 0; null: left out
    std::size_t stride = 0; // floats from vertex to vertex
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;
};

/// The length of a list.
/// throws  FileError where it is negative or more than `most`
template <class Source>
std::size_t read_length(Source& source, PlyType type, std::int64_t most, const char* what)
{
    const std::int64_t length = source.whole(type);
    if (length < 0 || length > most)
        throw FileError(fmt::format(
            "{}: {} has {} entries, 0 to {} are accepted", source.place(), what, length, most));
    return static_cast<std::size_t>(length);
}

inline constexpr std::int64_t kMaxPlyList = 0xFFFFFFFF; // entries; a guard, more than a file has

template <class Source>
void skip_property(Source& source, const PlyProperty& property)
{
    const std::size_t count =
        property.is_list ? read_length(source, property.count_type, kMaxPlyList, "a list") : 1;
    source.skip(property.type, count);
}

template <class Source>
void read_vertex(Source& source, const std::vector<PlyColumn>& columns, std::size_t vertex)
{
    for (const PlyColumn& column : columns) {
        if (column.to)
            column.to[vertex * column.stride] = source.number(column.type);
        else if (column.is_list)
            source.skip(column.type, read_length(source, column.count_type, kMaxPlyList, "a list"));
        else
            source.skip(column.type, 1);
    }
    source.end_element();
}

/// Faces have to name vertices below `vertices`.
struct PlyFaceElement {
    const PlyElement& element;
    std::size_t vertices = 0;
};

template <class Source>
[[noreturn]] void fail_index(
    const Source& source, std::int64_t index, const PlyFaceElement& of, std::size_t number)
{
    throw SceneError(fmt::format("{}: {} {}: index {} is out of range ({} vertices)",
        source.place(), of.element.kind == PlyElement::Kind::strips ? "strip" : "face", number,
        index, of.vertices));
}

/// Reads face `number` into `face`.
/// throws  FileError, SceneError: names the face
template <class Source>
void read_face(Source& source, const PlyFaceElement& of, std::size_t number, PlyFace& face)
{
    face.texcoord.clear();
    for (const PlyProperty& property : of.element.properties) {
        if (property.role == PlyRole::corners) {
            const std::int64_t count = source.whole(property.count_type);
            if (count < 0 || count > kMaxCorners)
                throw FileError(fmt::format("{}: face {}: {} corners, 0 to {} are accepted",
                    source.place(), number, count, kMaxCorners));
            face.corner.resize(static_cast<std::size_t>(count));
            for (std::uint32_t& corner : face.corner) {
                const std::int64_t index = source.whole(property.type);
                if (index < 0 || static_cast<std::uint64_t>(index) >= of.vertices)
                    fail_index(source, index, of, number);
                corner = static_cast<std::uint32_t>(index);
            }
        } else if (property.role == PlyRole::texcoord) {
            face.texcoord.resize(
                read_length(source, property.count_type, 2 * kMaxCorners, "texcoord"));
            for (float& value : face.texcoord) value = source.number(property.type);
        } else if (property.role != PlyRole::none) {
            face.color[int(property.role) - int(PlyRole::red)] = source.number(property.type);
        } else {
            skip_property(source, property);
        }
    }
    source.end_element();
}

/// Reads strip `number`: vertices, and negative numbers between strips.
template <class Source>
void read_strip(Source& source, const PlyFaceElement& of, std::size_t number,
    std::vector<std::int64_t>& vertices)
{
    for (const PlyProperty& property : of.element.properties) {
        if (property.role != PlyRole::corners) {
            skip_property(source, property);
            continue;
        }
        const std::size_t count = read_length(source, property.count_type, kMaxPlyList, "a strip");
        // Not allocated at once: the file may be shorter.
        vertices.clear();
        for (std::size_t k = 0; k < count; ++k) {
            std::int64_t index = source.whole(property.type);
            if (property.type == PlyType::uint32 && index == 0xFFFFFFFF) index = -1;
            if (index >= 0 && static_cast<std::uint64_t>(index) >= of.vertices)
                fail_index(source, index, of, number);
            vertices.push_back(index);
        }
    }
    source.end_element();
}

} // namespace firsthit
