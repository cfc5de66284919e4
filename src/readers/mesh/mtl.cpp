// mtl.cpp - the material libraries of OBJ files.
#include "readers/mesh/mtl.h"
#include "io/text_cursor.h"
#include "io/parse_number.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace firsthit {
namespace {

/// "0.5" is grey; "spectral file" and "xyz x y z" are kept out.
void read_color(TextCursor& text, glm::vec3& color)
{
    TextCursor ahead = text;
    const std::string_view first = ahead.next_word();
    if (first == "spectral" || first == "xyz") return;
    const float red = text.number("red");
    color = glm::vec3(red);
    if (!text.has_word()) return;
    color.g = text.number("green");
    color.b = text.number("blue");
}

/// "-halo" is a fall-off towards the rim, which Phong's model lacks.
float read_opacity(TextCursor& text)
{
    TextCursor ahead = text;
    if (ahead.next_word() == "-halo") text = ahead;
    return std::clamp(text.number("d"), 0.0f, 1.0f);
}

/// The options of a map come before its name: each is "-name" and some values; the name is what is
/// left after the last of them.
std::string read_map(TextCursor& text)
{
    const auto is_value = [](std::string_view word) {
        return word == "on" || word == "off" || parse_number(word);
    };
    for (;;) {
        TextCursor ahead = text;
        if (ahead.next_word().substr(0, 1) != "-" || !ahead.has_word()) break;
        text = ahead;
        // A value that looks like a number could be the file's name if nothing follows it.
        while (is_value(ahead.next_word()) && ahead.has_word()) text = ahead;
    }
    std::string file(text.rest_of_line());
    std::replace(file.begin(), file.end(), '\\', '/');
    return file;
}

} // namespace

std::vector<MtlMaterial> read_mtl(std::string_view bytes, const std::string& name)
{
    std::vector<MtlMaterial> materials;
    TextCursor text(bytes, name);
    while (text.next_line()) {
        const std::string_view word = text.next_word();
        if (word == "newmtl") {
            MtlMaterial& made = materials.emplace_back();
            made.name = text.rest_of_line();
            made.material.ambient = made.material.diffuse;
            continue;
        }
        const bool known = word == "Ka" || word == "Kd" || word == "Ks" || word == "Ns" ||
                           word == "Ni" || word == "d" || word == "Tr" || word == "map_Kd";
        if (!known) continue;
        if (materials.empty()) text.fail(fmt::format("{} stands before any newmtl", word));
        auto& [name_of, material, has_ambient, texture] = materials.back();
        if (word == "Ka") {
            read_color(text, material.ambient);
            has_ambient = true;
        } else if (word == "Kd") {
            read_color(text, material.diffuse);
            if (!has_ambient) material.ambient = material.diffuse;
        } else if (word == "Ks") {
            read_color(text, material.specular);
        } else if (word == "Ns") {
            material.shininess = std::max(0.0f, text.number("Ns"));
        } else if (word == "Ni") {
            material.ior = text.number("Ni");
        } else if (word == "Tr") {
            material.transmittance = std::clamp(text.number("Tr"), 0.0f, 1.0f);
        } else if (word == "d") {
            material.transmittance = 1.0f - read_opacity(text);
        } else {
            texture = read_map(text);
        }
    }
    return materials;
}

} // namespace firsthit
