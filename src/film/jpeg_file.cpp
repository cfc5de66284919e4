// jpeg_file.cpp - writes pictures as JPEG by libjpeg-turbo.
#include "film/picture_codes.h"

#include "io/output_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cstddef>
#include <cstdio> // which jpeglib.h needs before it

#if FIRSTHIT_WITH_JPEG
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>
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

/// Encodes the picture in memory. False if libjpeg failed; `message` has the reason.
bool encode_jpeg(const PictureCodes& picture, int quality, JpegWriter& writer)
{
    jpeg_compress_struct& jpeg = writer.jpeg;
    if (setjmp(writer.escape)) return false;
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &writer.bytes, &writer.size);
    jpeg.image_width = static_cast<JDIMENSION>(picture.width());
    jpeg.image_height = static_cast<JDIMENSION>(picture.height());
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
    for (int y = 0; y < picture.height(); ++y) {
        picture.row(y, writer.row);
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    return true;
}

} // namespace
#endif

void write_jpeg([[maybe_unused]] const PictureCodes& picture, [[maybe_unused]] int quality,
    const std::string& path)
{
#if FIRSTHIT_WITH_JPEG
    constexpr int kMaxJpegSide = JPEG_MAX_DIMENSION;
    if (picture.width() > kMaxJpegSide || picture.height() > kMaxJpegSide)
        throw FileError(
            fmt::format("{}: cannot write: JPEG holds at most {} x {} pixels, not {} x {}", path,
                kMaxJpegSide, kMaxJpegSide, picture.width(), picture.height()));
    JpegWriter writer;
    writer.row.resize(3 * static_cast<std::size_t>(picture.width()));
    writer.jpeg.err = jpeg_std_error(&writer.errors);
    writer.errors.error_exit = keep_jpeg_error;
    if (!encode_jpeg(picture, quality, writer))
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
