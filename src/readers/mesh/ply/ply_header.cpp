// ply_header.cpp - what a PLY file says about itself.
#include "readers/mesh/ply/ply_header.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace firsthit {
namespace {

struct TypeInfo {
    std::string_view name;  // of 1994
    std::string_view sized; // of later writers
    std::size_t size;
};
constexpr std::array<TypeInfo, 10> kTypes{{
    {"char", "int8", 1},
    {"uchar", "uint8", 1},
    {"short", "int16", 2},
    {"ushort", "uint16", 2},
    {"int", "int32", 4},
    {"uint", "uint32", 4},
    {"float", "float32", 4},
    {"double", "float64", 8},
    {"long", "int64", 8},
    {"ulong", "uint64", 8},
}};

// A guard: more would be no mesh.
constexpr std::size_t kMaxProperties = 256;

constexpr std::string_view kBom = "\xEF\xBB\xBF";

/// Reads the types of a header's properties.
struct PlyTypes {
    bool is_text; // numbers are words, whatever their types are
    Problems& problems;
};

PlyType read_type(TextCursor& text, const PlyTypes& types)
{
    const std::string_view word = text.next_word();
    for (std::size_t t = 0; t < kTypes.size(); ++t)
        if (word == kTypes[t].name || word == kTypes[t].sized) return static_cast<PlyType>(t);
    if (types.is_text && !word.empty()) {
        types.problems.add("values of unknown types are taken for numbers", "line", text.line());
        return PlyType::float32;
    }
    text.fail(fmt::format("'{}' is no type; accepted are char, uchar, short, ushort, int, uint, "
                          "float, double",
        printable(word)));
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
    return element;
}

PlyProperty read_property(TextCursor& text, const PlyTypes& types)
{
    PlyProperty property;
    TextCursor ahead = text;
    property.is_list = ahead.next_word() == "list";
    if (property.is_list) {
        text.next_word();
        property.count_type = read_type(text, types);
        if (!types.is_text && !is_whole(property.count_type))
            text.fail("the length of a list must be a whole number");
    }
    property.type = read_type(text, types);
    property.name = text.next_word();
    if (property.name.empty()) text.fail("a property has no name");
    return property;
}

PlyProperty* find(PlyElement& element, std::string_view name, bool is_list = false)
{
    for (PlyProperty& property : element.properties)
        if (property.name == name && property.is_list == is_list) return &property;
    return nullptr;
}

/// Gives the properties of these names their roles, in order from `first`, if all are there.
bool use(PlyElement& element, PlyRole first, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names)
        if (!find(element, name)) return false;
    int role = static_cast<int>(first);
    for (const std::string_view name : names) find(element, name)->role = PlyRole(role++);
    return true;
}

void use_color(PlyElement& element)
{
    if (use(element, PlyRole::red, {"red", "green", "blue"}))
        use(element, PlyRole::alpha, {"alpha"});
    else if (use(element, PlyRole::red, {"diffuse_red", "diffuse_green", "diffuse_blue"}))
        use(element, PlyRole::alpha, {"diffuse_alpha"});
    else if (use(element, PlyRole::red, {"r", "g", "b"}))
        use(element, PlyRole::alpha, {"a"});
}

void use_vertex(PlyElement& vertex, const TextCursor& text)
{
    vertex.kind = PlyElement::Kind::vertex;
    for (const std::string_view axis : {"x", "y", "z"})
        if (!find(vertex, axis))
            text.fail(fmt::format("the element vertex has no property '{}'", axis));
    use(vertex, PlyRole::x, {"x", "y", "z"});
    use(vertex, PlyRole::nx, {"nx", "ny", "nz"});
    if (!use(vertex, PlyRole::u, {"u", "v"}) && !use(vertex, PlyRole::u, {"s", "t"}))
        use(vertex, PlyRole::u, {"texture_u", "texture_v"});
    use_color(vertex);
}

void use_face(PlyElement& face, PlyElement::Kind kind, const TextCursor& text)
{
    face.kind = kind;
    PlyProperty* corners = find(face, "vertex_indices", true);
    if (!corners) corners = find(face, "vertex_index", true);
    if (!corners) text.fail(fmt::format("the element {} has no list 'vertex_indices'", face.name));
    corners->role = PlyRole::corners;
    if (kind == PlyElement::Kind::strips) return;
    if (PlyProperty* const texcoord = find(face, "texcoord", true))
        texcoord->role = PlyRole::texcoord;
    use_color(face);
}

void add_property(PlyElement& element, TextCursor& text, const PlyTypes& types)
{
    if (element.properties.size() == kMaxProperties)
        text.fail(fmt::format("more than {} properties", kMaxProperties));
    PlyProperty property = read_property(text, types);
    if (std::any_of(element.properties.begin(), element.properties.end(),
            [&](const PlyProperty& other) { return other.name == property.name; }))
        types.problems.add("of properties of the same name the first is used", "line", text.line());
    element.properties.push_back(std::move(property));
}

/// Gives the elements that are used their kinds, and the properties their roles.
void choose_elements(PlyHeader& header, const TextCursor& text, Problems& problems)
{
    bool vertex = false, faces = false, strips = false;
    for (PlyElement& element : header.elements) {
        if (element.name == "vertex" && !std::exchange(vertex, true))
            use_vertex(element, text);
        else if (element.name == "face" && element.count > 0 && !std::exchange(faces, true))
            use_face(element, PlyElement::Kind::faces, text);
        else if (element.name == "tristrips" && element.count > 0 && !std::exchange(strips, true))
            use_face(element, PlyElement::Kind::strips, text);
        else if (element.count > 0 && (element.name == "vertex" || element.name == "face" ||
                                          element.name == "tristrips"))
            problems.add("of elements of the same name the first is used");
    }
    if (!vertex) text.fail("there is no element 'vertex'");
}

/// The comment of programs that write textures.
void read_comment(TextCursor& text, PlyHeader& header)
{
    if (text.next_word() != "TextureFile") return;
    const std::string_view file = text.rest_of_line();
    if (!file.empty()) header.textures.emplace_back(file);
}

} // namespace

bool PlyElement::has(PlyRole role) const
{
    return std::any_of(properties.begin(), properties.end(),
        [&](const PlyProperty& property) { return property.role == role; });
}

bool PlyElement::has_list() const
{
    return std::any_of(properties.begin(), properties.end(),
        [&](const PlyProperty& property) { return property.is_list; });
}

PlyType PlyElement::type_of(PlyRole role) const
{
    return std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& property) {
        return property.role == role;
    })->type;
}

const PlyElement* PlyHeader::vertex() const
{
    for (const PlyElement& element : elements)
        if (element.kind == PlyElement::Kind::vertex) return &element;
    return nullptr;
}

const PlyElement* PlyHeader::faces() const
{
    for (const PlyElement& element : elements)
        if (element.kind == PlyElement::Kind::faces || element.kind == PlyElement::Kind::strips)
            return &element;
    return nullptr;
}

std::size_t ply_type_size(PlyType type)
{
    return kTypes[static_cast<std::size_t>(type)].size;
}

bool is_whole(PlyType type)
{
    return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name, Problems& problems)
{
    const std::size_t start = bytes.substr(0, kBom.size()) == kBom ? kBom.size() : 0;
    TextCursor text(bytes.substr(start), name);
    if (!text.next_line() || (text.next_word() != "ply" && text.word() != "PLY"))
        throw FileError(fmt::format("{}: no PLY file: its first line is not 'ply'", name));
    // Lines that end with CR alone: a line feed behind the last one is data.
    const bool lone_cr = bytes[start + text.consumed() - 1] == '\r';

    PlyHeader header;
    bool format_known = false;
    for (bool in_header = true; in_header;) {
        if (!text.next_line()) text.fail("the header has no 'end_header'");
        const std::string_view word = text.next_word();
        if (word.empty() || word == "obj_info") continue;
        if (word == "comment") {
            read_comment(text, header);
            continue;
        }
        if (word == "format") {
            header.format = read_format(text);
            format_known = true;
            text.next_word(); // the version; there is one
        } else if (word == "element") {
            if (header.elements.size() == kMaxProperties) text.fail("too many elements");
            header.elements.push_back(read_element(text));
        } else if (word == "property") {
            if (header.elements.empty()) text.fail("a property stands before any element");
            add_property(header.elements.back(), text,
                {format_known && header.format == PlyFormat::ascii, problems});
        } else if (word == "end_header") {
            in_header = false;
        } else {
            problems.add("unknown lines of the header are skipped", "line", text.line());
            continue;
        }
        if (text.has_word())
            problems.add("spare words in the header are skipped", "line", text.line());
    }
    header.size = start + text.consumed();
    if (lone_cr && bytes[header.size - 1] == '\n') --header.size;
    header.lines = text.line();
    if (!format_known) text.fail("the header has no 'format'");
    choose_elements(header, text, problems);
    return header;
}

} // namespace firsthit
