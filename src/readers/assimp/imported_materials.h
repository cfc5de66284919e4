// imported_materials.h - the materials and textures of what Assimp has read.
#pragma once

#include <firsthit/scene_builder.h>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace firsthit {

/// Makes materials of what Assimp tells: metallic-roughness where the file has such numbers, else Phong. Numbers
/// are taken as they are: colours linear. What cannot be shown gets a warning.
class ImportedMaterials {
  public:
    /// folder  where textures are; empty: only those in the file are read
    ImportedMaterials(
        const aiScene& from, std::string name, std::filesystem::path folder, SceneBuilder& builder);

    /// Adds all materials, and the default one.
    void add_all();

    /// The scene's number of a material; one that does not exist is the default.
    std::uint32_t number(unsigned material) const;

    /// Whether any material is metallic-roughness, so that white light is pi (see MetallicRoughness).
    bool physical() const { return physical_; }

    /// The normal map of a material.
    TextureRef normal_texture(unsigned material) const;

  private:
    Material material_of(const aiMaterial& from);
    MetallicRoughness metallic_roughness_of(const aiMaterial& from);
    Phong phong_of(const aiMaterial& from);
    void set_opacity(const aiMaterial& from, Material& made);
    void warn_once(const std::string& warning);

    /// What a picture of a texture becomes.
    enum class Use { color, data, opacity, roughness, metallic };
    TextureRef texture_of(const aiMaterial& from, aiTextureType type, Use use);
    std::optional<Picture> decode(const std::string& path);
    std::optional<Picture> picture_of(const aiTexture& embedded, const std::string& path);

    const aiScene& from_;
    std::string name_;
    std::filesystem::path folder_;
    SceneBuilder& builder_;
    std::vector<std::uint32_t> number_; // (materials + 1), the last is the default
    std::vector<TextureRef> normal_;    // (materials)
    bool physical_ = false;
    std::map<std::tuple<std::string, Use, int, int>, std::int32_t>
        texture_; // by path, use and wraps
    std::set<std::string> warned_;
};

} // namespace firsthit
