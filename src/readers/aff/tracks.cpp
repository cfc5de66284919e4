// tracks.cpp - the key-frame tracks of an AFF scene.
#include "readers/aff/statements.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstddef>
#include <string_view>

namespace firsthit::aff {
namespace {

// Of a spline: the first and the last key only shape the tangents (see scene/animate/track.h).
constexpr std::uint32_t kFewestKeys = 4;

glm::dvec4 read_vector(Lexer& lexer)
{
    return glm::dvec4(lexer.small_triple("a key's vector"), 0.0);
}

/// Axis and angle as a quaternion. Axes of the data are up to 8% longer or shorter than 1; what is
/// normalised is the quaternion, as in BART's own code.
glm::dvec4 read_rotation(Lexer& lexer)
{
    const glm::dvec3 axis = lexer.small_triple("a key's axis");
    const double half = 0.5 * glm::radians(double(lexer.small_number("a key's angle")));
    if (axis == glm::dvec3(0) && half != 0)
        lexer.fail_scene("a key turns about an axis of length 0");
    return glm::normalize(glm::dvec4(axis * std::sin(half), std::cos(half)));
}

void read_keys(
    Lexer& lexer, const char* block, glm::dvec4 (*read_value)(Lexer&), std::vector<TcbKey>& keys)
{
    if (!keys.empty()) lexer.fail_file(std::string("a second block '") + block + "' in one track");
    const std::uint32_t count = lexer.count("the number of keys");
    if (count < kFewestKeys)
        lexer.fail_scene(std::string("the block '") + block + "' should have 4 keys or more, not " +
                         std::to_string(count));
    for (std::uint32_t k = 0; k < count; ++k) {
        TcbKey key;
        key.time_s = lexer.small_number("a key's time");
        key.value = read_value(lexer);
        key.tension = lexer.small_number("a key's tension");
        key.continuity = lexer.small_number("a key's continuity");
        key.bias = lexer.small_number("a key's bias");
        keys.push_back(key);
    }
}

void read_visibility(Lexer& lexer, Track& track)
{
    if (!track.visibility.empty()) lexer.fail_file("a second block 'visibility' in one track");
    const std::uint32_t count = lexer.count("the number of keys");
    for (std::uint32_t k = 0; k < count; ++k) {
        const double time_s = lexer.small_number("a key's time");
        const std::int64_t visible = lexer.integer("a key's visibility");
        if (visible != 0 && visible != 1)
            lexer.fail_scene("a key's visibility should be 0 or 1, not " + std::to_string(visible));
        track.visibility.emplace_back(time_s, visible == 1);
    }
}

} // namespace

void read_track(Lexer& lexer, State& state)
{
    Track& track = state.builder.begin_track(lexer.word("the track's name"));
    lexer.expect("{", "k");
    for (;;) {
        const std::string_view block = lexer.next();
        if (block == "}") return;
        if (block == "transl")
            read_keys(lexer, "transl", read_vector, track.translation);
        else if (block == "scale")
            read_keys(lexer, "scale", read_vector, track.scale);
        else if (block == "rot")
            read_keys(lexer, "rot", read_rotation, track.rotation);
        else if (block == "visibility")
            read_visibility(lexer, track);
        else if (block.empty())
            lexer.fail_file("the file ends inside the track '" + track.name + "'");
        else
            lexer.fail_file("found " + in_quotes(block) +
                            " where transl, scale, rot, visibility or '}' of a track should stand");
    }
}

} // namespace firsthit::aff
