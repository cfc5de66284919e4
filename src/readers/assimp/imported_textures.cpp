// imported_textures.cpp - the textures of what Assimp has read, beside the file or in it.
#include "io/text_cursor.h"
#include "io/whole_file.h"
#include "readers/assimp/imported_materials.h"
#include "readers/image/image_file.h"

#include <firsthit/error.h>

#include <assimp/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

Wrap wrap_of(aiTextureMapMode mode)
{
    return mode == aiTextureMapMode_Mirror                                    ? Wrap::mirror
           : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? Wrap::clamp
                                                                              : Wrap::repeat;
}

/// Files that a path in a scene may mean, the likeliest first: paths are often those of another machine.
std::vector<std::filesystem::path> candidates(std::string path, const std::filesystem::path& folder)
{
    std::replace(path.begin(), path.end(), '\\', '/');
    if (path.starts_with("file://")) path.erase(0, 7);
    const std::filesystem::path given(path);
    const std::filesystem::path bare = given.filename();
    std::vector<std::filesystem::path> found;
    if (given.is_relative()) found.push_back(folder / given);
    if (!bare.empty()) {
        found.push_back(folder / bare);
        found.push_back(folder / "textures" / bare);
    }
    return found;
}

bool has_alpha(const Picture& picture)
{
    return std::any_of(picture.pixel.begin(), picture.pixel.end(),
        [](std::uint32_t pixel) { return pixel >> 24 != 255; });
}

/// Opacity is in alpha; pictures without have it in their brightness.
void move_to_alpha(Picture& picture)
{
    if (has_alpha(picture)) return;
    for (std::uint32_t& pixel : picture.pixel) {
        const std::uint32_t sum = (pixel & 255) + (pixel >> 8 & 255) + (pixel >> 16 & 255);
        pixel = (pixel & 0xFFFFFFu) | (sum / 3) << 24;
    }
}

/// A picture of one number as the channel where it is looked for; the others are 1.
void keep_channel(Picture& picture, unsigned channel)
{
    for (std::uint32_t& pixel : picture.pixel) {
        const std::uint32_t value = pixel >> (8 * channel) & 255;
        pixel = 0xFFFFFFFFu & ~(255u << (8 * channel));
        pixel |= value << (8 * channel);
    }
}

} // namespace

/// returns  no texture where it cannot be had
TextureRef ImportedMaterials::texture_of(const aiMaterial& from, aiTextureType type, Use use)
{
    aiString path;
    unsigned set = 0;
    aiTextureMapMode wraps[3] = {
        aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    TextureRef made;
    if (from.GetTexture(type, 0, &path, nullptr, &set, nullptr, nullptr, wraps) != aiReturn_SUCCESS)
        return made;
    const Sampler sampler{.wrap_u = wrap_of(wraps[0]), .wrap_v = wrap_of(wraps[1])};
    const auto [entry, is_new] = texture_.try_emplace(
        {path.C_Str(), use, static_cast<int>(sampler.wrap_u), static_cast<int>(sampler.wrap_v)},
        -1);
    if (is_new) {
        std::optional<Picture> picture = decode(path.C_Str());
        if (picture) {
            if (use == Use::opacity) move_to_alpha(*picture);
            if (use == Use::roughness) keep_channel(*picture, 1);
            if (use == Use::metallic) keep_channel(*picture, 2);
            const Encoding encoding = use == Use::color ? Encoding::srgb : Encoding::linear;
            Texture texture(path.C_Str(), *picture, encoding);
            texture.set_sampler(sampler);
            entry->second = static_cast<std::int32_t>(builder_.add_texture(std::move(texture)));
        }
    }
    made.texture = entry->second;
    made.uv_set = set == 1 ? 1 : 0;
    if (set > 1 && made.texture >= 0)
        warn_once(
            fmt::format("{}: texture coordinates {} are not read, the first are used", name_, set));
    return made;
}

std::optional<Picture> ImportedMaterials::decode(const std::string& path)
{
    try {
        if (const aiTexture* embedded = from_.GetEmbeddedTexture(path.c_str()))
            return picture_of(*embedded, path);
        if (folder_.empty()) return {};
        for (const std::filesystem::path& file : candidates(path, folder_)) {
            std::error_code error;
            if (!std::filesystem::is_regular_file(file, error)) continue;
            builder_.add_file(file.string());
            return decode_picture(file.string(), read_whole_file(file));
        }
        warn_once(fmt::format(
            "{}: texture '{}' is missing; a plain colour is used", name_, printable(path)));
    } catch (const Error& error) {
        warn_once(fmt::format("{}; a plain colour is used", error.what()));
    }
    return {};
}

/// A picture that lies in the file: packed as PNG or another format, or texel by texel.
std::optional<Picture> ImportedMaterials::picture_of(
    const aiTexture& embedded, const std::string& path)
{
    const std::string name = fmt::format("{}: texture '{}'", name_, printable(path));
    if (!embedded.pcData || embedded.mWidth == 0) throw FileError(fmt::format("{} is empty", name));
    if (embedded.mHeight == 0)
        return decode_picture(
            name, std::span(reinterpret_cast<const char*>(embedded.pcData), embedded.mWidth));
    if (embedded.mWidth > unsigned(Texture::kMaxSide) ||
        embedded.mHeight > unsigned(Texture::kMaxSide))
        throw FileError(fmt::format("{} is {} x {}, at most {} a side are accepted", name,
            embedded.mWidth, embedded.mHeight, Texture::kMaxSide));
    Picture made;
    made.width = static_cast<int>(embedded.mWidth);
    made.height = static_cast<int>(embedded.mHeight);
    const std::size_t texels = std::size_t(embedded.mWidth) * embedded.mHeight;
    for (std::size_t k = 0; k < texels; ++k) {
        const aiTexel& t = embedded.pcData[k];
        made.pixel.push_back(
            t.r | std::uint32_t(t.g) << 8 | std::uint32_t(t.b) << 16 | std::uint32_t(t.a) << 24);
    }
    return made;
}

} // namespace firsthit
