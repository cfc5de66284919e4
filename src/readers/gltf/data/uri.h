// uri.h - where a glTF document's bytes are: data URIs and names of files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace firsthit::gltf {

bool is_data_uri(std::string_view uri);

/// The bytes of a data URI, in base64 or percent-encoded; nothing where it is damaged.
/// mime_type  becomes what it says, without parameters
std::optional<std::string> decode_data_uri(std::string_view uri, std::string& mime_type);

/// %20 and the like as bytes. A percent sign without two hexadecimal digits stays.
std::string percent_decoded(std::string_view uri);

/// Whether it names a protocol (http://...). One letter and a colon is a drive.
bool has_scheme(std::string_view uri);

/// The file that a URI means: percent-decoded; as it is written where only that exists; with slashes
/// for backslashes
/// where only that exists.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, const std::string& uri);

} // namespace firsthit::gltf
