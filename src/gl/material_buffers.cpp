// material_buffers.cpp - materials and textures where shaders read them.
#include "gl/material_buffers.h"

#include "base/srgb.h"
#include "gl/bindings.h"
#include "gl/context.h"
#include "shade/phong_exponent.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <span>

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

void fill_materials(const Scene& scene, std::vector<MaterialData>& all)
{
    all.clear();
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
}

/// What comes before the texels; their places are filled in.
void fill_tables(const Scene& scene, std::vector<std::uint32_t>& words)
{
    words.clear();
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
}

/// Calls body(level, its first texel's place) for all levels of all textures.
template <class Body>
void for_levels(const Scene& scene, std::size_t first, const Body& body)
{
    for (const Texture& texture : scene.textures)
        for (const Texture::Level& level : texture.levels) {
            body(level, first);
            first += texels_of(level);
        }
}

} // namespace

void MaterialBuffers::update(const Scene& scene, std::int64_t max_storage_bytes)
{
    fill_materials(scene, material_);
    if (kept_material_.follow(material_)) {
        materials_.assign(std::span<const MaterialData>(material_));
        ++uploads_;
        uploaded_bytes_ += material_.size() * sizeof(MaterialData);
    }

    fill_tables(scene, tables_);
    std::size_t size = tables_.size();
    for_levels(
        scene, 0, [&](const Texture::Level& level, std::size_t) { size += texels_of(level); });
    if (size * 4 > std::size_t(max_storage_bytes))
        throw DeviceError(
            fmt::format("OpenGL: the textures take {} bytes, one buffer may have {} ({})", size * 4,
                max_storage_bytes, driver_name()));
    bool same = words_.size() == size && std::equal(tables_.begin(), tables_.end(), words_.begin());
    if (same)
        for_levels(scene, tables_.size(), [&](const Texture::Level& level, std::size_t first) {
            const auto* texel = level.texel.data();
            same = same && std::equal(texel, texel + texels_of(level), words_.data() + first);
        });
    if (same) return;

    words_.resize(size);
    std::copy(tables_.begin(), tables_.end(), words_.begin());
    for_levels(scene, tables_.size(), [&](const Texture::Level& level, std::size_t first) {
        std::copy_n(level.texel.data(), texels_of(level), words_.data() + first);
    });
    texture_words_.assign(std::span<const std::uint32_t>(words_));
    ++uploads_;
    uploaded_bytes_ += words_.size() * sizeof(std::uint32_t);
    check("uploading textures");
}

void MaterialBuffers::bind()
{
    material_texels_.look_at(materials_, GL_RGBA32F, 16);
    material_texels_.bind(kMaterialsUnit);
    word_texels_.look_at(texture_words_, GL_R32UI, 4);
    word_texels_.bind(kTexturesUnit);
}

} // namespace firsthit::gl
