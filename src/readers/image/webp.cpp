// webp.cpp - decodes WebP pictures by libwebp.
#include "readers/image/webp.h"

#include "readers/image/pnm.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#if FIRSTHIT_WITH_WEBP
#include <webp/decode.h>
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace firsthit {

bool can_decode_webp()
{
#if FIRSTHIT_WITH_WEBP
    return true;
#else
    return false;
#endif
}

bool is_webp(std::span<const char> bytes)
{
    const std::string_view text(bytes.data(), bytes.size());
    return text.starts_with("RIFF") && text.size() >= 12 && text.substr(8, 4) == "WEBP";
}

Picture decode_webp(const std::string& name, [[maybe_unused]] std::span<const char> bytes)
{
#if FIRSTHIT_WITH_WEBP
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    WebPBitstreamFeatures features{};
    // The size first: a small file can promise a picture that fills the memory.
    if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
        throw FileError(fmt::format("{}: a damaged WebP picture", name));
    check_picture_size(name, features.width, features.height);
    if (features.has_animation)
        throw FileError(fmt::format("{}: an animated WebP picture, which is not accepted", name));
    Picture picture{features.width, features.height, {}};
    picture.pixel.resize(std::size_t(features.width) * std::size_t(features.height));
    static_assert(std::endian::native == std::endian::little); // red is the lowest byte
    auto* const rgba = reinterpret_cast<std::uint8_t*>(picture.pixel.data());
    if (!WebPDecodeRGBAInto(data, bytes.size(), rgba, picture.pixel.size() * 4, features.width * 4))
        throw FileError(fmt::format("{}: a damaged WebP picture", name));
    return picture;
#else
    throw FileError(fmt::format(
        "{}: a WebP picture needs the library libwebp, without which this program was built",
        name));
#endif
}

} // namespace firsthit
