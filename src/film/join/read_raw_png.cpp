// read_raw_png.cpp - a .png's pixels as its file holds them.
#include "film/join/raw_picture.h"

#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <string_view>

namespace firsthit {
namespace {

/// All objects that reading with libpng needs. libpng reports errors by longjmp, which must not skip
/// destructors, so the functions that call it have none themselves.
struct PngReader {
    const std::string& path;
    std::string bytes;
    std::size_t place = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_bytep> rows;
    char message[128] = "";

    explicit PngReader(const std::string& file) : path(file), bytes(read_whole_file(file)) {}
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

void keep_read_error(png_structp png, png_const_charp message)
{
    auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader.message, message, sizeof reader.message - 1);
    png_longjmp(png, 1);
}

void ignore_read_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep data, std::size_t count)
{
    auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (reader.bytes.size() - reader.place < count) png_error(png, "the file ends too early");
    std::memcpy(data, reader.bytes.data() + reader.place, count);
    reader.place += count;
}

bool read_head(PngReader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, &reader, take_bytes);
    png_read_info(reader.png, reader.info);
    return true;
}

bool read_pixels(PngReader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, reader.rows.data());
    png_read_end(reader.png, nullptr);
    return true;
}

[[noreturn]] void fail_to_read(const PngReader& reader)
{
    throw FileError(fmt::format("{}: cannot be read as PNG: {}", reader.path,
        *reader.message ? reader.message : "out of memory"));
}

} // namespace

RawPicture read_raw_png(const std::string& path, const glm::ivec2& size)
{
    PngReader reader(path);
    reader.png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, &reader, keep_read_error, ignore_read_warning);
    if (reader.png) reader.info = png_create_info_struct(reader.png);
    if (!reader.info || !read_head(reader)) fail_to_read(reader);

    RawPicture picture;
    picture.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    picture.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    check_raw_size(path, {picture.width, picture.height}, size);
    const RawPng kind{
        png_get_color_type(reader.png, reader.info), png_get_bit_depth(reader.png, reader.info)};
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE || kind.bit_depth < 8)
        throw FileError(fmt::format("{}: has a palette or less than 8 bits: accepted are PNG of 8 "
                                    "and 16 bits, grey or RGB, with or without alpha",
            path));
    picture.kind = kind;
    picture.pixel_bytes = static_cast<std::size_t>(png_get_channels(reader.png, reader.info)) *
                          static_cast<std::size_t>(kind.bit_depth / 8);
    const std::size_t row_bytes = picture.pixel_bytes * static_cast<std::size_t>(picture.width);
    picture.bytes.resize(row_bytes * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y)
        reader.rows.push_back(picture.bytes.data() + static_cast<std::size_t>(y) * row_bytes);
    if (!read_pixels(reader)) fail_to_read(reader);
    return picture;
}

} // namespace firsthit
