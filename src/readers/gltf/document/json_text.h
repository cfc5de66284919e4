// json_text.h - JSON from a text of any bytes, within limits.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace firsthit::gltf {

using Json = nlohmann::json;

/// limits  2^24 values, nested 64 deep; checked before memory is taken
/// name    stands in the messages
/// kind    of file, which stands there too
/// throws  FileError: no JSON (names line and column), beyond a limit
Json parse_json(std::string_view text, const std::string& name, const char* kind = "a glTF file");

} // namespace firsthit::gltf
