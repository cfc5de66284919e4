// pnm.h - binary PPM and PGM pictures.
#pragma once

#include <firsthit/texture.h>

#include <span>
#include <string>

namespace firsthit {

/// Whether these bytes start like a binary PGM (P5) or PPM (P6).
bool is_pnm(std::span<const char> bytes);

/// The first picture of the file. Values of another maximum than 255 are scaled to it.
/// throws  FileError: a malformed header, a size that check_picture_size refuses, too few bytes
Picture decode_pnm(const std::string& name, std::span<const char> bytes);

/// throws  FileError: an empty picture, or one larger than a texture may be
void check_picture_size(const std::string& name, long long width, long long height);

} // namespace firsthit
