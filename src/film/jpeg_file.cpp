// jpeg_file.cpp - encodes pictures as JPEG by libjpeg-turbo, and writes them.
#include "film/picture_codes.h"

#include "io/output_file.h"

#include <firsthit/error.h>
#include <firsthit/picture.h>

#include <fmt/format.h>

#include <cstddef>
#include <cstdio> // which jpeglib.h needs before it

#if FIRSTHIT_WITH_JPEG
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>
#include <functional>
#include <vector>
#endif

namespace firsthit {

bool can_write_jpeg()
{
#if FIRSTHIT_WITH_JPEG
    return true;
#else
    return false;
#endif
}

#if FIRSTHIT_WITH_JPEG
namespace {

/// All objects that writing needs: libjpeg reports errors by a function that must not return, and a longjmp must
/// not skip destructors.
struct JpegWriter {
    jpeg_error_mgr errors{}; // first, so that its address is the writer's
    std::jmp_buf escape;
    char message[JMSG_LENGTH_MAX] = "";
    jpeg_compress_struct jpeg{};
    std::vector<std::uint8_t> row;
    unsigned char* bytes = nullptr; // that libjpeg allocates
    unsigned long size = 0;

    JpegWriter() = default;
    ~JpegWriter()
    {
        jpeg_destroy_compress(&jpeg);
        std::free(bytes);
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;
};

void keep_jpeg_error(j_common_ptr jpeg)
{
    auto* const writer = reinterpret_cast<JpegWriter*>(jpeg->err);
    jpeg->err->format_message(jpeg, writer->message);
    std::longjmp(writer->escape, 1);
}

/// What is encoded. row  fills in a row of RGB
struct JpegPicture {
    int width, height;
    std::function<void(int, std::span<std::uint8_t>)> row;
};

/// Encodes the picture in memory. False if libjpeg failed; `message` has the reason.
bool encode(const JpegPicture& picture, int quality, JpegWriter& writer)
{
    writer.row.resize(3 * static_cast<std::size_t>(picture.width));
    writer.jpeg.err = jpeg_std_error(&writer.errors);
    writer.errors.error_exit = keep_jpeg_error;
    jpeg_compress_struct& jpeg = writer.jpeg;
    if (setjmp(writer.escape)) return false;
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &writer.bytes, &writer.size);
    jpeg.image_width = static_cast<JDIMENSION>(picture.width);
    jpeg.image_height = static_cast<JDIMENSION>(picture.height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    constexpr int kFullColor = 90; // from this quality on, the blur of halved colours would be seen
    if (quality >= kFullColor)
        for (int c = 0; c < jpeg.num_components; ++c)
            jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
    jpeg_start_compress(&jpeg, TRUE);
    JSAMPROW rows[] = {writer.row.data()};
    for (int y = 0; y < picture.height; ++y) {
        picture.row(y, writer.row);
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    return true;
}

constexpr int kMaxJpegSide = JPEG_MAX_DIMENSION;

} // namespace
#endif

std::string encode_jpeg([[maybe_unused]] std::span<const std::uint8_t> rgba,
    [[maybe_unused]] int width, [[maybe_unused]] int height, [[maybe_unused]] int quality)
{
#if FIRSTHIT_WITH_JPEG
    if (quality < 1 || quality > 100)
        throw ArgumentError(fmt::format("quality {} is out of range: 1 to 100", quality));
    if (width < 1 || height < 1 || width > kMaxJpegSide || height > kMaxJpegSide)
        throw ArgumentError(fmt::format(
            "JPEG holds 1 to {} pixels a side, not {} x {}", kMaxJpegSide, width, height));
    const std::size_t row_values = 4 * static_cast<std::size_t>(width);
    if (rgba.size() != row_values * static_cast<std::size_t>(height))
        throw ArgumentError(fmt::format(
            "{} values are no picture of {} x {} pixels with 4 each", rgba.size(), width, height));
    JpegWriter writer;
    const auto row = [&](int y, std::span<std::uint8_t> rgb) {
        const std::uint8_t* from = rgba.data() + static_cast<std::size_t>(y) * row_values;
        for (std::size_t k = 0; k < rgb.size(); k += 3, from += 4)
            for (std::size_t c = 0; c < 3; ++c) rgb[k + c] = from[c];
    };
    if (!encode({width, height, row}, quality, writer))
        throw ArgumentError(fmt::format("cannot encode as JPEG: {}", writer.message));
    return {reinterpret_cast<const char*>(writer.bytes), writer.size};
#else
    throw ArgumentError("JPEG needs the library libjpeg, without which this program was built");
#endif
}

void write_jpeg([[maybe_unused]] const PictureCodes& picture, [[maybe_unused]] int quality,
    const std::string& path)
{
#if FIRSTHIT_WITH_JPEG
    if (picture.width() > kMaxJpegSide || picture.height() > kMaxJpegSide)
        throw FileError(
            fmt::format("{}: cannot write: JPEG holds at most {} x {} pixels, not {} x {}", path,
                kMaxJpegSide, kMaxJpegSide, picture.width(), picture.height()));
    JpegWriter writer;
    const auto row = [&](int y, std::span<std::uint8_t> rgb) { picture.row(y, rgb); };
    if (!encode({picture.width(), picture.height(), row}, quality, writer))
        throw FileError(fmt::format("{}: cannot write: {}", path, writer.message));
    OutputFile file(path);
    file.write(writer.bytes, writer.size);
    file.commit();
#else
    throw FileError(fmt::format(
        "{}: cannot write: JPEG needs the library libjpeg, without which this program was built",
        path));
#endif
}

} // namespace firsthit
