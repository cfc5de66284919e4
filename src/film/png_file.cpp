// png_file.cpp - writes colours as 8-bit sRGB PNG, and distances as grey ones of 16 bits.
#include "io/output_file.h"
#include "film/picture_codes.h"
#include "film/picture_files.h"
#include "film/png_rows.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <cstring>
#include <exception>

namespace firsthit {

namespace {

/// All objects that writing a picture with libpng needs. libpng reports errors by longjmp, which
/// must not skip destructors, so the function that calls it keeps these objects here and has none
/// itself.
struct PngWriter {
    OutputFile file;
    const PngRows& rows;
    std::vector<std::uint8_t> row;
    png_structp png = nullptr;
    png_infop info = nullptr;
    char message[128] = "";

    PngWriter(const PngRows& picture, const std::string& path)
        : file(path),
          rows(picture),
          row(picture.row_bytes)
    {
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
};

void keep_error(png_structp png, png_const_charp message)
{
    auto& writer = *static_cast<PngWriter*>(png_get_error_ptr(png));
    std::strncpy(writer.message, message, sizeof writer.message - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep data, std::size_t bytes)
{
    auto& writer = *static_cast<PngWriter*>(png_get_io_ptr(png));
    bool written = true;
    try {
        writer.file.write(data, bytes);
    } catch (const std::exception&) {
        written = false; // commit() throws it again
    }
    if (!written) png_error(png, "cannot write");
}

void flush_nothing(png_structp) {}

/// Writes the picture. False if libpng failed; `message` has the reason.
bool write_rows(PngWriter& writer)
{
    png_structp png = writer.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &writer, write_bytes, flush_nothing);
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(writer.rows.width),
        static_cast<png_uint_32>(writer.rows.height), writer.rows.bit_depth, writer.rows.color_type,
        PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (writer.rows.is_srgb()) png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(png, 1);
    // Runs alone would be quicker, but the pattern of dithering makes files three times as large then.
    png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
    png_set_compression_buffer_size(png, 1 << 18);
    png_write_info(png, writer.info);
    for (int y = 0; y < writer.rows.height; ++y) {
        writer.rows.fill(y, writer.row);
        png_write_row(png, writer.row.data());
    }
    png_write_end(png, nullptr);
    return true;
}

void write(PngWriter& writer)
{
    writer.png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, keep_error, ignore_warning);
    if (writer.png) writer.info = png_create_info_struct(writer.png);
    const bool written = writer.info && write_rows(writer);
    if (!written && !writer.file.failed())
        throw FileError(fmt::format("{}: cannot write: {}", writer.file.path(),
            *writer.message ? writer.message : "out of memory"));
    writer.file.commit();
}

} // namespace

bool PngRows::is_srgb() const
{
    return bit_depth == 8 && (color_type & PNG_COLOR_MASK_COLOR) != 0;
}

void write_png_rows(const PngRows& rows, const std::string& path)
{
    PngWriter writer(rows, path);
    write(writer);
}

void write_png(const PictureCodes& picture, const std::string& path)
{
    const bool alpha = picture.channels() == 4;
    write_png_rows(
        {.width = picture.width(),
            .height = picture.height(),
            .color_type = alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
            .bit_depth = 8,
            .row_bytes = static_cast<std::size_t>(picture.width()) *
                         static_cast<std::size_t>(picture.channels()),
            .fill = [&](int y, std::span<std::uint8_t> bytes) { picture.row(y, bytes); }},
        path);
}

void write_gray_png(
    std::span<const std::uint16_t> value, int width, int height, const std::string& path)
{
    const auto columns = static_cast<std::size_t>(width);
    const auto fill = [&](int y, std::span<std::uint8_t> bytes) {
        for (std::size_t x = 0; x < columns; ++x) {
            const std::uint16_t gray = value[static_cast<std::size_t>(y) * columns + x];
            bytes[2 * x] = static_cast<std::uint8_t>(gray >> 8);
            bytes[2 * x + 1] = static_cast<std::uint8_t>(gray & 255);
        }
    };
    write_png_rows({.width = width,
                       .height = height,
                       .color_type = PNG_COLOR_TYPE_GRAY,
                       .bit_depth = 16,
                       .row_bytes = 2 * columns,
                       .fill = fill},
        path);
}

} // namespace firsthit
