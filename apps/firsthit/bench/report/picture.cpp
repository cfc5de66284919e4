// picture.cpp - small pictures for the page: of a film's colours, of its items, parts of them enlarged.
#include "bench/report/picture.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace firsthit::cli::bench {

namespace {

/// IEC 61966-2-1.
std::uint8_t srgb_code(float linear)
{
    const double x = std::clamp(double(linear), 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

Picture empty_picture(int width, int height)
{
    return {width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height))};
}

/// Neighbouring ids get unlike colours: Knuth 1997, vol. 3, 6.4 (multiplication by the golden ratio).
std::uint32_t mixed(std::uint32_t id)
{
    const std::uint32_t x = (id + 1) * 2654435769u;
    return x ^ x >> 15;
}

} // namespace

Picture picture_of(const Film& film)
{
    Picture picture = empty_picture(film.width, film.height);
    if (film.color.value.size() != picture.rgb.size())
        throw ArgumentError("the film has no colours to show");
    std::transform(
        film.color.value.begin(), film.color.value.end(), picture.rgb.begin(), srgb_code);
    return picture;
}

Picture picture_of_items(const Film& film)
{
    Picture picture = empty_picture(film.width, film.height);
    if (3 * film.item.size() != picture.rgb.size())
        throw ArgumentError("the film has no items to show");
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        if (film.item[k] == kNoItem) continue;
        const std::uint32_t bits = mixed(film.item[k]);
        // Bright enough to be told from none.
        for (std::size_t channel = 0; channel < 3; ++channel)
            picture.rgb[3 * k + channel] =
                std::uint8_t(64 + (bits >> (8 * channel) & 255) * 191 / 255);
    }
    return picture;
}

Picture enlarged(const Picture& picture, const Region& part, int times)
{
    const int left = std::clamp(part.x, 0, picture.width - 1);
    const int top = std::clamp(part.y, 0, picture.height - 1);
    const int width = std::clamp(part.width, 1, picture.width - left);
    const int height = std::clamp(part.height, 1, picture.height - top);
    Picture result = empty_picture(width * times, height * times);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const auto from = 3 * (std::size_t(top + y / times) * std::size_t(picture.width) +
                                      std::size_t(left + x / times));
            const auto to = 3 * (std::size_t(y) * std::size_t(result.width) + std::size_t(x));
            std::copy_n(&picture.rgb[from], 3, &result.rgb[to]);
        }
    return result;
}

std::vector<std::uint8_t> png(const Picture& picture)
{
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t bytes = 0;
    std::vector<std::uint8_t> file;
    if (png_image_write_get_memory_size(image, bytes, 0, picture.rgb.data(), 0, nullptr)) {
        file.resize(bytes);
        if (png_image_write_to_memory(
                &image, file.data(), &bytes, 0, picture.rgb.data(), 0, nullptr)) {
            file.resize(bytes);
            return file;
        }
    }
    throw FileError(std::string("a picture of the page cannot be made: ") + image.message);
}

} // namespace firsthit::cli::bench
