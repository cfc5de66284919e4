// material_buffers.cpp - materials and textures where shaders read them.
#include "gl/material_buffers.h"

#include "base/srgb.h"
#include "gl/bindings.h"
#include "gl/context.h"
#include "gl/gpu_data.h"
#include "shade/phong_exponent.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace firsthit::gl {
namespace {

/// As shade/sample_texture-inl.h asks of a level.
bool can_sample(const Texture::Level& level)
{
    constexpr int kMaxSide = 1 << 22;
    return level.width > 0 && level.height > 0 && level.width <= kMaxSide &&
           level.height <= kMaxSide &&
           std::int64_t(level.width) * level.height <= std::numeric_limits<std::int32_t>::max() &&
           level.texel.size() >= std::size_t(level.width) * std::size_t(level.height);
}

std::size_t texels_of(const Texture::Level& level)
{
    return can_sample(level) ? std::size_t(level.width) * std::size_t(level.height) : 0;
}

std::vector<MaterialData> material_data(const Scene& scene)
{
    std::vector<MaterialData> all;
    for (const Material& material : scene.materials) {
        const PhongExponent exponent = phong_exponent(material.shininess);
        MaterialData data{.ambient = material.ambient,
            .diffuse = material.diffuse,
            .shininess = exponent.value,
            .specular = material.specular,
            .whole_shininess = exponent.whole};
        const auto texture = std::size_t(material.texture);
        if (material.texture >= 0 && texture < scene.textures.size() &&
            !scene.textures[texture].levels.empty())
            data.texture = material.texture;
        all.push_back(data);
    }
    return all;
}

/// What comes before the texels; their places are filled in.
std::vector<std::uint32_t> texture_tables(const Scene& scene)
{
    std::vector<std::uint32_t> words;
    for (const float light : linear_from_srgb())
        words.push_back(std::bit_cast<std::uint32_t>(light));
    std::size_t row = words.size() + 2 * scene.textures.size(), levels = 0;
    for (const Texture& texture : scene.textures) {
        words.push_back(std::uint32_t(row + 3 * levels));
        words.push_back(std::uint32_t(texture.levels.size()));
        levels += texture.levels.size();
    }
    std::size_t texel = row + 3 * levels;
    for (const Texture& texture : scene.textures)
        for (const Texture::Level& level : texture.levels) {
            const std::size_t texels = texels_of(level);
            words.push_back(std::uint32_t(texel));
            words.push_back(texels > 0 ? std::uint32_t(level.width) : 0);
            words.push_back(texels > 0 ? std::uint32_t(level.height) : 0);
            texel += texels;
        }
    return words;
}

} // namespace

void MaterialBuffers::upload(const Scene& scene, std::int64_t max_storage_bytes)
{
    const std::vector<std::uint32_t> tables = texture_tables(scene);
    std::size_t words = tables.size();
    for (const Texture& texture : scene.textures)
        for (const Texture::Level& level : texture.levels) words += texels_of(level);
    if (words * 4 > std::size_t(max_storage_bytes))
        throw DeviceError(fmt::format("OpenGL: the textures take {} bytes, one buffer may have {} "
                                      "({})",
            words * 4, max_storage_bytes, driver_name()));

    texture_words_.resize(words * 4);
    texture_words_.upload(0, tables.data(), tables.size() * 4);
    std::size_t next = tables.size() * 4;
    for (const Texture& texture : scene.textures)
        for (const Texture::Level& level : texture.levels) {
            texture_words_.upload(next, level.texel.data(), texels_of(level) * 4);
            next += texels_of(level) * 4;
        }
    materials_.assign(std::span<const MaterialData>(material_data(scene)));
    check("uploading materials and textures");
}

void MaterialBuffers::bind() const
{
    materials_.bind_storage(kMaterials);
    texture_words_.bind_storage(kTextureWords);
}

} // namespace firsthit::gl
