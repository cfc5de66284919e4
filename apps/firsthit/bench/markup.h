// markup.h - texts and bytes as parts of HTML and SVG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace firsthit::cli::bench {

/// & < > " ' as entities, so that a name stays a name in text and in attributes. What XML does not allow
/// (control characters, broken UTF-8) becomes U+FFFD.
std::string escaped(std::string_view text);

/// RFC 4648, with padding, in one line.
std::string base64(std::span<const std::uint8_t> bytes);

} // namespace firsthit::cli::bench
