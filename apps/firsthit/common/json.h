// json.h - objects that keep the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace firsthit::cli {

using Json = nlohmann::ordered_json;

/// Indented text with a newline at its end. What is no UTF-8 in a name becomes U+FFFD.
std::string to_text(const Json& json);

} // namespace firsthit::cli
