// mtl_map.h - a texture as a material library names it, with its options.
#pragma once

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

#include <string>
#include <string_view>

namespace firsthit {

/// What stands behind map_Kd and the like.
struct MtlMap {
    std::string file;        // with slashes, as it is written else; empty: there is no map
    glm::vec2 scale{1};      // -s: multiplies texture coordinates
    glm::vec2 offset{0};     // -o: is added to them then
    bool clamp = false;      // -clamp: the edge goes on outside of the picture
    char channel = 0;        // -imfchan: r, g, b, m (alpha), l or z; 0: not said
    float strength = 1;      // -bm: multiplies the slopes of a normal map
    bool bad_number = false; // an option lacks a number, or it is not finite: its default is kept

    explicit operator bool() const { return !file.empty(); }
    /// From texture coordinates (u, v, 1) to where the picture is sampled.
    glm::mat3x2 transform() const { return {scale.x, 0, 0, scale.y, offset.x, offset.y}; }
};

/// Reads a file's name, which may have blanks or quotation marks, and options before and behind it. Options
/// that are not listed above are left out with what belongs to them.
MtlMap read_mtl_map(std::string_view text);

} // namespace firsthit
