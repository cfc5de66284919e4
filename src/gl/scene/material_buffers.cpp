// material_buffers.cpp - uploads materials and textures for shaders.
#include "gl/scene/material_buffers.h"

#include "gl/bindings.h"
#include "gl/device/context.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace firsthit::gl {
namespace {

constexpr std::size_t kTexelWords = sizeof(Texel) / sizeof(std::uint32_t);

void fill_materials(const Scene& scene, std::vector<MaterialTexels>& all)
{
    all.clear();
    const auto has_levels = [&](std::int32_t texture) {
        return texture >= 0 && std::size_t(texture) < scene.textures.size() &&
               scene.textures[std::size_t(texture)].levels() > 0;
    };
    const auto is_drawn = [&](const TextureRef& map) {
        return !(map.uv_set == 0 ? scene.uv : scene.uv1).empty() && has_levels(map.texture);
    };
    for (const Material& material : scene.materials) {
        const std::int32_t texture = texture_number(material);
        const bool drawn = has_levels(texture) && !scene.uv.empty();
        all.push_back(material_texels(material, drawn ? texture : -1, is_drawn));
    }
}

int only_model_of(const Scene& scene)
{
    if (scene.materials.empty()) return 0;
    const std::size_t first = scene.materials[0].model.index();
    const auto other = [&](const Material& m) { return m.model.index() != first; };
    return std::any_of(scene.materials.begin(), scene.materials.end(), other) ? -1 : int(first);
}

/// Fills in the tables that precede the texels, with the positions of the texels.
void fill_tables(const Scene& scene, std::vector<std::uint32_t>& words)
{
    words.clear();
    std::size_t row = 4 * scene.textures.size(), levels = 0;
    for (const Texture& texture : scene.textures) {
        words.push_back(std::uint32_t(row + levels));
        const Sampler& sampler = texture.sampler();
        words.push_back(std::uint32_t(texture.levels()) | std::uint32_t(sampler.wrap_u) << 8 |
                        std::uint32_t(sampler.wrap_v) << 12 | std::uint32_t(sampler.nearest) << 16);
        words.push_back(std::uint32_t(texture.width()));
        words.push_back(std::uint32_t(texture.height()));
        levels += std::size_t(texture.levels());
    }
    std::size_t texel = row + levels;
    for (const Texture& texture : scene.textures) {
        for (int l = 0; l < texture.levels(); ++l)
            words.push_back(
                std::uint32_t(texel + kTexelWords * std::size_t(texture.first()[std::size_t(l)])));
        texel += kTexelWords * texture.texels().size();
    }
}

/// Calls body(bytes of its texels, index of its first word) for each texture.
template <class Body>
void for_textures(const Scene& scene, std::size_t first, const Body& body)
{
    for (const Texture& texture : scene.textures) {
        body(std::as_bytes(texture.texels()), first);
        first += kTexelWords * texture.texels().size();
    }
}

} // namespace

void MaterialBuffers::update(const Scene& scene, std::int64_t max_storage_bytes)
{
    only_model_ = only_model_of(scene);
    fill_materials(scene, material_);
    if (kept_material_.follow(material_)) {
        materials_.assign(std::span<const MaterialTexels>(material_));
        ++uploads_;
        uploaded_bytes_ += material_.size() * sizeof(MaterialTexels);
    }

    fill_tables(scene, tables_);
    std::size_t size = tables_.size();
    for (const Texture& texture : scene.textures) size += kTexelWords * texture.texels().size();
    if (size * 4 > std::size_t(max_storage_bytes))
        throw DeviceError(
            fmt::format("OpenGL: the textures take {} bytes, one buffer may have {} ({})", size * 4,
                max_storage_bytes, driver_name()));
    bool same = words_.size() == size && std::equal(tables_.begin(), tables_.end(), words_.begin());
    if (same)
        for_textures(
            scene, tables_.size(), [&](std::span<const std::byte> texels, std::size_t first) {
                same = same && (texels.empty() || std::memcmp(texels.data(), words_.data() + first,
                                                      texels.size()) == 0);
            });
    if (same) return;

    words_.resize(size);
    std::copy(tables_.begin(), tables_.end(), words_.begin());
    for_textures(scene, tables_.size(), [&](std::span<const std::byte> texels, std::size_t first) {
        if (!texels.empty()) std::memcpy(words_.data() + first, texels.data(), texels.size());
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
