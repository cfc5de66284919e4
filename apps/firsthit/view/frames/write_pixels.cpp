// write_pixels.cpp - encodes what is on a screen, and writes it as a file.
#include "view/frames/write_pixels.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>
#include <png.h>

#include <cstddef>

namespace firsthit::cli::view {

std::string encode_png(const std::vector<std::uint8_t>& rgba, int width, int height, bool quick)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    if (quick) image.flags = PNG_IMAGE_FLAG_FAST;
    std::vector<std::uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t k = 0; k < rgba.size(); ++k)
        if (k % 4 != 3) rgb.push_back(rgba[k]);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr))
        throw Error(fmt::format("cannot encode as .png: {}", image.message));
    bytes.resize(size);
    return bytes;
}

void write_pixels(
    const std::vector<std::uint8_t>& rgba, int width, int height, const std::string& path)
{
    write_file(path, encode_png(rgba, width, height));
}

} // namespace firsthit::cli::view
