// raw_picture.h - a picture as its file holds it: pixels as bytes, and what they mean.
#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace firsthit {

/// Of a .png: what libpng calls them.
struct RawPng {
    int color_type = 0;
    int bit_depth = 0;
    bool operator==(const RawPng&) const = default;
};

/// Of an .exr: names of channels in the file's order, and Imf::PixelType of each.
struct RawExr {
    std::vector<std::pair<std::string, int>> channels;
    bool operator==(const RawExr&) const = default;
};

/// Of an .npy: the type as its header has it, and values in a pixel; 0: the array has two dimensions.
struct RawNpy {
    std::string type;
    std::size_t values = 0;
    bool operator==(const RawNpy&) const = default;
};

using RawKind = std::variant<RawPng, RawExr, RawNpy>;

/// (height, width, pixel_bytes), row 0 at the top.
struct RawPicture {
    RawKind kind;
    int width = 0;
    int height = 0;
    std::size_t pixel_bytes = 0;
    std::vector<std::uint8_t> bytes;
};

/// What a kind is, for messages, as "PNG, 8 bits, RGB".
std::string kind_text(const RawKind& kind);

/// Reads a file that must have a size: one with another is an error before memory is taken for it.
/// throws  FileError
RawPicture read_raw_png(const std::string& path, const glm::ivec2& size);
RawPicture read_raw_exr(const std::string& path, const glm::ivec2& size);
RawPicture read_raw_npy(const std::string& path, const glm::ivec2& size);

/// Writes it as the library's own files of its kind are.
/// throws  FileError
void write_raw_picture(const RawPicture& picture, const std::string& path);

/// throws  FileError: the file has another size
void check_raw_size(const std::string& path, const glm::ivec2& found, const glm::ivec2& size);

} // namespace firsthit
