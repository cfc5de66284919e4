// webp.h - WebP pictures, by the library libwebp where it was there at build time.
#pragma once

#include <firsthit/texture.h>

#include <span>
#include <string>

namespace firsthit {

/// Whether the library was there at build time.
bool can_decode_webp();

/// Whether these bytes start like a WebP picture.
bool is_webp(std::span<const char> bytes);

/// The picture.
/// throws  FileError: damaged, animated, a size that check_picture_size refuses, or no library (names it)
Picture decode_webp(const std::string& name, std::span<const char> bytes);

} // namespace firsthit
