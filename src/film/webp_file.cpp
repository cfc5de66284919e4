// webp_file.cpp - writes pictures as WebP by libwebp.
#include "film/picture_codes.h"

#include "io/output_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#if FIRSTHIT_WITH_WEBP
#include <webp/encode.h>

#include <memory>
#include <vector>
#endif

#include <cstddef>

namespace firsthit {

bool can_write_webp()
{
#if FIRSTHIT_WITH_WEBP
    return true;
#else
    return false;
#endif
}

#if FIRSTHIT_WITH_WEBP
namespace {

struct WebpBytes {
    std::uint8_t* bytes = nullptr; // that libwebp allocates
    std::size_t size = 0;

    WebpBytes() = default;
    ~WebpBytes() { WebPFree(bytes); }
    WebpBytes(const WebpBytes&) = delete;
    WebpBytes& operator=(const WebpBytes&) = delete;
};

void encode_webp(const PictureCodes& picture, int quality, WebpBytes& to)
{
    const auto row_bytes =
        static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.channels());
    std::vector<std::uint8_t> codes(row_bytes * static_cast<std::size_t>(picture.height()));
    for (int y = 0; y < picture.height(); ++y)
        picture.row(
            y, std::span(codes).subspan(static_cast<std::size_t>(y) * row_bytes, row_bytes));
    const int w = picture.width(), h = picture.height(), stride = static_cast<int>(row_bytes);
    const auto lossy = static_cast<float>(quality);
    const std::uint8_t* const data = codes.data();
    const bool alpha = picture.channels() == 4;
    if (quality == 100)
        to.size = alpha ? WebPEncodeLosslessRGBA(data, w, h, stride, &to.bytes)
                        : WebPEncodeLosslessRGB(data, w, h, stride, &to.bytes);
    else
        to.size = alpha ? WebPEncodeRGBA(data, w, h, stride, lossy, &to.bytes)
                        : WebPEncodeRGB(data, w, h, stride, lossy, &to.bytes);
}

} // namespace
#endif

void write_webp([[maybe_unused]] const PictureCodes& picture, [[maybe_unused]] int quality,
    const std::string& path)
{
#if FIRSTHIT_WITH_WEBP
    constexpr int kMaxWebpSide = WEBP_MAX_DIMENSION;
    if (picture.width() > kMaxWebpSide || picture.height() > kMaxWebpSide)
        throw FileError(
            fmt::format("{}: cannot write: WebP holds at most {} x {} pixels, not {} x {}", path,
                kMaxWebpSide, kMaxWebpSide, picture.width(), picture.height()));
    WebpBytes encoded;
    encode_webp(picture, quality, encoded);
    if (encoded.size == 0)
        throw FileError(
            fmt::format("{}: cannot write: libwebp failed to encode the picture", path));
    OutputFile file(path);
    file.write(encoded.bytes, encoded.size);
    file.commit();
#else
    throw FileError(fmt::format(
        "{}: cannot write: WebP needs the library libwebp, without which this program was built",
        path));
#endif
}

} // namespace firsthit
