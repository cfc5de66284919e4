// ply_header.cpp - what a PLY file says about itself.
#include "readers/mesh/ply_header.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace firsthit {
namespace {

struct TypeInfo {
    std::string_view name;  // of 1994
    std::string_view sized; // of later writers
    std::size_t size;
};
constexpr std::array<TypeInfo, 8> kTypes{{
    {"char", "int8", 1},
    {"uchar", "uint8", 1},
    {"short", "int16", 2},
    {"ushort", "uint16", 2},
    {"int", "int32", 4},
    {"uint", "uint32", 4},
    {"float", "float32", 4},
    {"double", "float64", 8},
}};

// A guard: more would be no mesh.
constexpr std::size_t kMaxProperties = 256;

template <class T>
double value_of(const char* bytes, bool big_endian)
{
    std::array<char, sizeof(T)> copy;
    std::memcpy(copy.data(), bytes, sizeof(T));
    if (big_endian) std::reverse(copy.begin(), copy.end());
    T value;
    std::memcpy(&value, copy.data(), sizeof(T));
    return static_cast<double>(value);
}

PlyType read_type(TextCursor& text)
{
    const std::string_view word = text.next_word();
    for (std::size_t t = 0; t < kTypes.size(); ++t)
        if (word == kTypes[t].name || word == kTypes[t].sized) return static_cast<PlyType>(t);
    text.fail(fmt::format("'{}' is no type; accepted are char, uchar, short, ushort, int, uint, "
                          "float, double",
        printable(word)));
}

bool is_float(PlyType type)
{
    return type == PlyType::float32 || type == PlyType::float64;
}

PlyFormat read_format(TextCursor& text)
{
    const std::string_view word = text.next_word();
    if (word == "ascii") return PlyFormat::ascii;
    if (word == "binary_little_endian") return PlyFormat::little_endian;
    if (word == "binary_big_endian") return PlyFormat::big_endian;
    text.fail(fmt::format("format is '{}'; accepted are ascii, binary_little_endian, "
                          "binary_big_endian",
        printable(word)));
}

PlyElement read_element(TextCursor& text)
{
    PlyElement element;
    element.name = text.next_word();
    const std::int64_t count = text.integer("the number of elements");
    // 2^32 vertices cannot be numbered.
    if (count < 0 || count > 0xFFFFFFFFll)
        text.fail(fmt::format(
            "{} elements '{}', 0 to 4294967295 are accepted", count, printable(element.name)));
    element.count = static_cast<std::size_t>(count);
    text.expect_end();
    return element;
}

PlyProperty read_property(TextCursor& text)
{
    PlyProperty property;
    TextCursor ahead = text;
    property.is_list = ahead.next_word() == "list";
    if (property.is_list) {
        text.next_word();
        property.count_type = read_type(text);
        if (is_float(property.count_type)) text.fail("the length of a list must be a whole number");
    }
    property.type = read_type(text);
    property.name = text.next_word();
    if (property.name.empty()) text.fail("a property has no name");
    text.expect_end();
    return property;
}

/// The first of the names that the element has gets used.
bool use(PlyElement& element, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names)
        for (PlyProperty& property : element.properties)
            if (property.name == name) return property.used = true;
    return false;
}

void use_vertex(PlyElement& vertex, const TextCursor& text)
{
    for (const PlyProperty& property : vertex.properties)
        if (property.is_list)
            text.fail(fmt::format("list '{}' in the element vertex", printable(property.name)));
    for (const std::string_view axis : {"x", "y", "z"})
        if (!use(vertex, {axis}))
            text.fail(fmt::format("the element vertex has no property '{}'", axis));
    const auto has = [&](std::string_view name) {
        return std::any_of(vertex.properties.begin(), vertex.properties.end(),
            [&](const PlyProperty& p) { return p.name == name; });
    };
    if (has("nx") && has("ny") && has("nz"))
        for (const std::string_view axis : {"nx", "ny", "nz"}) use(vertex, {axis});
    for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}})
        if (has(u) && has(v)) {
            use(vertex, {u});
            use(vertex, {v});
            break;
        }
}

void use_face(PlyElement& face, const TextCursor& text)
{
    if (!use(face, {"vertex_indices", "vertex_index"}))
        text.fail("the element face has no list 'vertex_indices'");
    for (const PlyProperty& property : face.properties)
        if (property.used && (!property.is_list || is_float(property.type)))
            text.fail(fmt::format("'{}' must be a list of whole numbers", property.name));
}

void add_property(PlyElement& element, const TextCursor& text, PlyProperty property)
{
    if (element.properties.size() == kMaxProperties)
        text.fail(fmt::format("more than {} properties", kMaxProperties));
    for (const PlyProperty& other : element.properties)
        if (other.name == property.name)
            text.fail(fmt::format("property '{}' is there twice", printable(property.name)));
    element.properties.push_back(std::move(property));
}

} // namespace

std::size_t ply_type_size(PlyType type)
{
    return kTypes[static_cast<std::size_t>(type)].size;
}

double ply_value(const char* bytes, PlyType type, bool big_endian)
{
    switch (type) {
    case PlyType::int8:
        return value_of<std::int8_t>(bytes, big_endian);
    case PlyType::uint8:
        return value_of<std::uint8_t>(bytes, big_endian);
    case PlyType::int16:
        return value_of<std::int16_t>(bytes, big_endian);
    case PlyType::uint16:
        return value_of<std::uint16_t>(bytes, big_endian);
    case PlyType::int32:
        return value_of<std::int32_t>(bytes, big_endian);
    case PlyType::uint32:
        return value_of<std::uint32_t>(bytes, big_endian);
    case PlyType::float32:
        return value_of<float>(bytes, big_endian);
    case PlyType::float64:
        return value_of<double>(bytes, big_endian);
    }
    return 0;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name)
{
    TextCursor text(bytes, name);
    if (!text.next_line() || text.next_word() != "ply")
        throw FileError(fmt::format("{}: no PLY file: its first line is not 'ply'", name));

    // Collect the elements as they stand.
    PlyHeader header;
    std::vector<PlyElement> elements;
    bool format_known = false;
    for (bool in_header = true; in_header;) {
        if (!text.next_line()) text.fail("the header has no 'end_header'");
        const std::string_view word = text.next_word();
        if (word.empty() || word == "comment" || word == "obj_info") continue;
        if (word == "format") {
            header.format = read_format(text);
            format_known = true;
        } else if (word == "element") {
            if (elements.size() == kMaxProperties) text.fail("too many elements");
            elements.push_back(read_element(text));
        } else if (word == "property") {
            if (elements.empty()) text.fail("a property stands before any element");
            add_property(elements.back(), text, read_property(text));
        } else if (word == "end_header") {
            in_header = false;
        } else {
            text.fail(fmt::format("'{}' is no word of a PLY header", printable(word)));
        }
    }
    header.size = text.consumed();
    header.lines = text.line();
    if (!format_known) text.fail("the header has no 'format'");

    // Keep two of them.
    const auto is_at = [&](std::size_t place, std::string_view wanted) {
        return elements.size() > place && elements[place].name == wanted;
    };
    if (!is_at(0, "vertex") || !is_at(1, "face"))
        text.fail(
            "the first elements must be 'vertex' and 'face'; a cloud of points has no triangles");
    header.vertex = std::move(elements[0]);
    header.face = std::move(elements[1]);
    use_vertex(header.vertex, text);
    use_face(header.face, text);
    return header;
}

} // namespace firsthit
