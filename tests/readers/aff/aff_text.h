// aff_text.h - AFF scenes from texts in memory.
#pragma once

#include "readers/aff/aff.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <map>
#include <string>

namespace firsthit {

/// The scene of a main file "main.aff", which may include those of `files`. The texture "red.ppm"
/// exists, others do not.
inline Scene scene_of(const std::string& text, const std::map<std::string, std::string>& files = {},
    const LoadSettings& settings = {})
{
    const AffFiles access = {.include_text =
                                 [&](const std::string& name) {
                                     const auto found = files.find(name);
                                     if (found == files.end())
                                         throw FileError(name + ": no such file");
                                     return found->second;
                                 },
        .texture =
            [](const std::string& name) {
                if (name != "red.ppm") throw FileError(name + ": no such file");
                return Texture(name, Picture{1, 1, {0xFF0000FFu}});
            }};
    return parse_aff("main.aff", text, access, settings);
}

/// One triangle in the plane z = 0 as a polygon statement.
inline const std::string kTriangle = "p 3  0 0 0  1 0 0  0 1 0\n";

} // namespace firsthit
