// mtl_textures.cpp - the pictures of material libraries, as textures of a scene.
#include "readers/mesh/mtl/mtl_textures.h"

#include "io/whole_file.h"
#include "readers/find_beside.h"
#include "readers/image/image_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

bool is_file(const std::filesystem::path& path)
{
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

unsigned channel(std::uint32_t pixel, int number)
{
    return pixel >> (8 * number) & 255u;
}

/// Of codes, by the weights of Rec. 601, which add up to 256.
unsigned brightness(std::uint32_t pixel)
{
    return (77 * channel(pixel, 0) + 150 * channel(pixel, 1) + 29 * channel(pixel, 2) + 128) >> 8;
}

constexpr std::uint32_t kOpaqueBits = 0xFF000000u;

/// The pixel at the place of a picture that a pixel of another size has.
std::uint32_t pixel_at(const Picture& picture, const Picture& size, std::size_t k)
{
    const auto width = static_cast<std::size_t>(size.width);
    const std::size_t x = (k % width) * std::size_t(picture.width) / width;
    const std::size_t y = (k / width) * std::size_t(picture.height) / std::size_t(size.height);
    return picture.pixel[y * std::size_t(picture.width) + x];
}

/// Puts the opacity into the alpha of a picture.
/// returns  whether nearly all of it is nearly 0 or 1
bool make_opacity(Picture& picture, char from)
{
    const bool has_alpha = std::any_of(picture.pixel.begin(), picture.pixel.end(),
        [](std::uint32_t p) { return (p & kOpaqueBits) != kOpaqueBits; });
    if (from == 0) from = has_alpha ? 'm' : 'l';
    std::size_t between = 0;
    for (std::uint32_t& pixel : picture.pixel) {
        const unsigned share = from == 'r'   ? channel(pixel, 0)
                               : from == 'g' ? channel(pixel, 1)
                               : from == 'b' ? channel(pixel, 2)
                               : from == 'm' ? channel(pixel, 3)
                                             : brightness(pixel);
        pixel = (pixel & ~kOpaqueBits) | share << 24;
        between += share > 16 && share < 239;
    }
    return between <= picture.pixel.size() / 10;
}

} // namespace

std::string MtlTextures::key_of(const MtlMap& map) const
{
    return find_beside(folder_, map.file).string() + (map.clamp ? "|clamp" : "|repeat");
}

std::int32_t MtlTextures::once(const std::string& key, const std::function<std::int32_t()>& make)
{
    const auto [found, added] = number_.try_emplace(key, -1);
    if (added) found->second = make();
    return found->second;
}

void MtlTextures::read_file(const MtlMap& map,
    const std::function<void(const std::string& path, const std::string& bytes)>& decode)
{
    const std::filesystem::path path = find_beside(folder_, map.file);
    if (failed_.count(path.string()) > 0) return;
    if (is_file(path)) scene_.add_file(path.string());
    try {
        decode(path.string(), read_whole_file(path));
    } catch (const Error& error) {
        scene_.warn(fmt::format("{}; a plain colour is used", error.what()));
        failed_[path.string()] = true;
    }
}

std::optional<Picture> MtlTextures::read(const MtlMap& map)
{
    std::optional<Picture> picture;
    read_file(map, [&](const std::string& path, const std::string& bytes) {
        picture = decode_picture(path, bytes);
    });
    return picture;
}

std::int32_t MtlTextures::add(const MtlMap& map, const Picture& picture, Encoding encoding)
{
    return add(map, Texture(find_beside(folder_, map.file).string(), picture, encoding));
}

std::int32_t MtlTextures::add(const MtlMap& map, Texture texture)
{
    if (map.clamp) texture.set_sampler({.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp});
    return static_cast<std::int32_t>(scene_.add_texture(std::move(texture)));
}

std::int32_t MtlTextures::number(const MtlMap& map, Encoding encoding)
{
    if (!map) return -1;
    return once((encoding == Encoding::srgb ? "colour|" : "data|") + key_of(map), [&] {
        std::optional<Texture> texture;
        read_file(map, [&](const std::string& path, const std::string& bytes) {
            texture = decode_texture(path, bytes, encoding);
        });
        return texture ? add(map, std::move(*texture)) : -1;
    });
}

MtlTextures::Opacity MtlTextures::opacity(const MtlMap& map)
{
    if (!map) return {};
    const std::string key =
        fmt::format("opacity {}|{}", map.channel == 0 ? '-' : map.channel, key_of(map));
    const std::int32_t number = once(key, [&] {
        std::optional<Picture> picture = read(map);
        if (!picture) return -1;
        is_mask_[key] = make_opacity(*picture, map.channel);
        return add(map, *picture, Encoding::srgb);
    });
    return {.number = number, .is_mask = number >= 0 && is_mask_[key]};
}

std::int32_t MtlTextures::metallic_roughness(const MtlMap& roughness, const MtlMap& metallic)
{
    if (!roughness && !metallic) return -1;
    if (roughness && metallic && key_of(roughness) == key_of(metallic))
        return number(roughness, Encoding::linear);
    const std::string key = fmt::format("roughness|{}|metallic|{}",
        roughness ? key_of(roughness) : "", metallic ? key_of(metallic) : "");
    return once(key, [&] {
        const std::optional<Picture> rough = roughness ? read(roughness) : std::nullopt;
        const std::optional<Picture> metal = metallic ? read(metallic) : std::nullopt;
        if (!rough && !metal) return -1;
        // The finer picture has the size, of the other the nearest pixels are taken.
        const bool by_rough = rough && (!metal || rough->pixel.size() >= metal->pixel.size());
        Picture both = by_rough ? *rough : *metal;
        for (std::size_t k = 0; k < both.pixel.size(); ++k) {
            const unsigned r = rough ? brightness(pixel_at(*rough, both, k)) : 255;
            const unsigned m = metal ? brightness(pixel_at(*metal, both, k)) : 255;
            both.pixel[k] = kOpaqueBits | m << 16 | r << 8;
        }
        return add(by_rough ? roughness : metallic, both, Encoding::linear);
    });
}

} // namespace firsthit
