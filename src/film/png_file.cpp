// png_file.cpp - writes colour as 8-bit sRGB PNG.
#include "base/srgb.h"
#include "io/output_file.h"
#include "film/picture_files.h"

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
    const PlaneView& color;
    std::vector<std::uint8_t> row;
    png_structp png = nullptr;
    png_infop info = nullptr;
    char message[128] = "";

    PngWriter(const PlaneView& plane, const std::string& path)
        : file(path),
          color(plane),
          row(3 * static_cast<std::size_t>(plane.width))
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
    const auto width = static_cast<png_uint_32>(writer.color.width);
    const auto height = static_cast<png_uint_32>(writer.color.height);
    png_set_write_fn(png, &writer, write_bytes, flush_nothing);
    png_set_IHDR(png, writer.info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
        PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
    png_set_compression_buffer_size(png, 1 << 18);
    png_write_info(png, writer.info);
    const std::size_t row_values = writer.row.size();
    for (png_uint_32 y = 0; y < height; ++y) {
        srgb_table().codes(writer.color.value.subspan(y * row_values, row_values), writer.row);
        png_write_row(png, writer.row.data());
    }
    png_write_end(png, nullptr);
    return true;
}

} // namespace

void write_png(const PlaneView& color, const std::string& path)
{
    PngWriter writer(color, path);
    writer.png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, keep_error, ignore_warning);
    if (writer.png) writer.info = png_create_info_struct(writer.png);
    const bool written = writer.info && write_rows(writer);
    if (!written && !writer.file.failed())
        throw FileError(fmt::format(
            "{}: cannot write: {}", path, *writer.message ? writer.message : "out of memory"));
    writer.file.commit();
}

} // namespace firsthit
