// image_file.cpp - reads pictures by the libraries stb_image and libwebp and our own PPM decoder.
#include "readers/image/image_file.h"

#include "readers/image/jpeg_check.h"
#include "readers/image/picture_cache.h"
#include "readers/image/pnm.h"
#include "readers/image/webp.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>

namespace firsthit {
namespace {

bool is_radiance(std::span<const char> bytes)
{
    return bytes.size() >= 2 && bytes[0] == '#' && bytes[1] == '?';
}

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// Refuses a PNG whose chunks do not fit the file, because stb_image takes the memory that a chunk
/// promises before it looks for its bytes.
void check_png_chunks(const std::string& name, std::span<const char> bytes)
{
    constexpr std::size_t kAround = 12; // length, type and checksum of a chunk
    std::size_t at = kPngSignature.size();
    while (at + kAround <= bytes.size()) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k)
            length = (length << 8) | static_cast<unsigned char>(bytes[at + k]);
        const bool is_last = std::string_view(&bytes[at + 4], 4) == "IEND";
        if (length > bytes.size() - at - kAround) break;
        if (is_last) return;
        at += kAround + length;
    }
    throw FileError(fmt::format("{}: the PNG picture is cut off or damaged at byte {}", name, at));
}

/// PNG and JPEG.
Picture decode_stb(const std::string& name, std::span<const char> bytes)
{
    const auto fail = [&] {
        const char* reason = stbi_failure_reason();
        throw FileError(
            fmt::format("{}: not a PNG, JPEG, WebP or binary PPM picture, or a damaged one ({})",
                name, reason ? reason : "unknown reason"));
    };
    if (is_radiance(bytes))
        throw FileError(fmt::format(
            "{}: a Radiance picture is no texture: accepted are PNG, JPEG, WebP and binary PPM",
            name));
    if (bytes.size() > std::size_t(std::numeric_limits<int>::max()))
        throw FileError(
            fmt::format("{}: a picture file of {} bytes is too large", name, bytes.size()));
    if (std::string_view(bytes.data(), bytes.size()).starts_with(kPngSignature))
        check_png_chunks(name, bytes);
    else
        check_jpeg_tables(name, bytes);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    // The size first: a small file can promise a picture that fills the memory.
    if (!stbi_info_from_memory(data, size, &width, &height, &channels)) fail();
    check_picture_size(name, width, height);

    const std::unique_ptr<stbi_uc, void (*)(void*)> rgba(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4), stbi_image_free);
    if (!rgba) fail();
    Picture picture{width, height, {}};
    picture.pixel.resize(std::size_t(width) * std::size_t(height));
    for (std::size_t k = 0; k < picture.pixel.size(); ++k)
        picture.pixel[k] = std::uint32_t(rgba.get()[4 * k]) |
                           (std::uint32_t(rgba.get()[4 * k + 1]) << 8) |
                           (std::uint32_t(rgba.get()[4 * k + 2]) << 16) |
                           (std::uint32_t(rgba.get()[4 * k + 3]) << 24);
    return picture;
}

Picture decode_any(const std::string& name, std::span<const char> bytes)
{
    if (is_pnm(bytes)) return decode_pnm(name, bytes);
    if (is_webp(bytes)) return decode_webp(name, bytes);
    return decode_stb(name, bytes);
}

} // namespace

Picture decode_picture(const std::string& name, std::span<const char> bytes)
{
    PictureCache* const cache = PictureCache::current();
    if (!cache) return decode_any(name, bytes);
    if (const std::shared_ptr<const Picture> known = cache->find(bytes)) return *known;
    Picture made = decode_any(name, bytes);
    cache->add(bytes, made);
    return made;
}

Texture decode_texture(const std::string& name, std::span<const char> bytes, Encoding encoding)
{
    PictureCache* const cache = PictureCache::current();
    if (!cache) return Texture(name, decode_any(name, bytes), encoding);
    if (const std::shared_ptr<const Texture> known = cache->find_texture(bytes, encoding)) {
        Texture copy = *known;
        copy.rename(name);
        return copy;
    }
    Texture made(name, decode_any(name, bytes), encoding);
    cache->add_texture(bytes, encoding, made);
    return made;
}

Texture read_texture(const std::filesystem::path& path)
{
    const std::string bytes = read_whole_file(path);
    return decode_texture(path.string(), bytes);
}

} // namespace firsthit
