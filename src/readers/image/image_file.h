// image_file.h - reads pictures that are wrapped around triangles.
#pragma once

#include <firsthit/texture.h>

#include <filesystem>
#include <span>
#include <string>

namespace firsthit {

/// Reads a PNG, JPEG, WebP, PPM or PGM (binary, of 8 or 16 bits) and makes its smaller levels. The
/// texture's name is the file's.
/// throws  FileError: unreadable, another format, damaged, wider or higher than 16,384 or of more
///         than 2^26 texels
Texture read_texture(const std::filesystem::path& path);

/// The same for a file's bytes; `name` is for errors. From the thread's PictureCache where it has one.
Texture decode_texture(
    const std::string& name, std::span<const char> bytes, Encoding encoding = Encoding::srgb);

/// The picture alone, without smaller levels; from the cache too.
Picture decode_picture(const std::string& name, std::span<const char> bytes);

} // namespace firsthit
