// pnm.cpp - decodes binary PPM and PGM pictures.
#include "readers/image/pnm.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

constexpr long long kMaxSide = Texture::kMaxSide;
constexpr long long kMaxTexels = Texture::kMaxTexels;

/// Reads the numbers of the header, between which white space and comments stand.
class Header {
  public:
    Header(const std::string& name, std::span<const char> bytes) : name_(name), bytes_(bytes) {}

    long long number(const char* what)
    {
        skip_space();
        long long value = 0;
        const std::size_t start = at_;
        while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9')
            value = std::min(value * 10 + (bytes_[at_++] - '0'), 1'000'000'000LL);
        if (at_ == start)
            throw FileError(fmt::format("{}: the picture's header lacks its {}", name_, what));
        return value;
    }

    /// The offset of the pixels: one white space after the last number.
    std::size_t end() const { return std::min(at_ + 1, bytes_.size()); }

  private:
    void skip_space()
    {
        while (at_ < bytes_.size()) {
            const char c = bytes_[at_];
            if (c == '#')
                while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
            else if (c == ' ' || (c >= '\t' && c <= '\r'))
                ++at_;
            else
                return;
        }
    }

    const std::string& name_;
    std::span<const char> bytes_;
    std::size_t at_ = 2; // after P5 or P6
};

} // namespace

bool is_pnm(std::span<const char> bytes)
{
    return bytes.size() >= 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '6');
}

void check_picture_size(const std::string& name, long long width, long long height)
{
    if (width < 1 || height < 1)
        throw FileError(fmt::format("{}: the picture is empty ({} x {})", name, width, height));
    if (width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
        throw FileError(fmt::format("{}: a picture of {} x {} is too large, at most {} on a side "
                                    "and {} texels are accepted",
            name, width, height, kMaxSide, kMaxTexels));
}

Picture decode_pnm(const std::string& name, std::span<const char> bytes)
{
    Header header(name, bytes);
    const long long width = header.number("width");
    const long long height = header.number("height");
    const long long maximum = header.number("largest value");
    check_picture_size(name, width, height);
    if (maximum < 1 || maximum > 65535)
        throw FileError(fmt::format(
            "{}: the picture's largest value is {}, 1 to 65535 is accepted", name, maximum));

    const std::size_t channels = bytes[1] == '6' ? 3 : 1;
    const std::size_t width_bytes = maximum > 255 ? 2 : 1;
    const std::size_t texels = static_cast<std::size_t>(width * height);
    const std::span<const char> data = bytes.subspan(header.end());
    const std::size_t needed = texels * channels * width_bytes;
    if (data.size() < needed)
        throw FileError(fmt::format(
            "{}: the picture has {} bytes of pixels instead of {}", name, data.size(), needed));

    const auto value = [&](std::size_t k) {
        const auto byte = [&](std::size_t i) {
            return static_cast<std::uint32_t>(static_cast<unsigned char>(data[i]));
        };
        const std::uint32_t raw = width_bytes == 1 ? byte(k) : (byte(2 * k) << 8) | byte(2 * k + 1);
        const auto top = static_cast<std::uint32_t>(maximum);
        return top == 255 ? raw : (std::min(raw, top) * 255 + top / 2) / top;
    };
    Picture picture{static_cast<int>(width), static_cast<int>(height), {}};
    picture.pixel.resize(texels);
    for (std::size_t k = 0; k < texels; ++k) {
        const std::uint32_t red = value(channels * k);
        const std::uint32_t green = channels == 3 ? value(3 * k + 1) : red;
        const std::uint32_t blue = channels == 3 ? value(3 * k + 2) : red;
        picture.pixel[k] = red | (green << 8) | (blue << 16) | 0xFF000000u;
    }
    return picture;
}

} // namespace firsthit
