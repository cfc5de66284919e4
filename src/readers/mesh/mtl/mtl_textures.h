// mtl_textures.h - the pictures of material libraries, as textures of a scene.
#pragma once

#include "readers/mesh/mtl/mtl_map.h"

#include <firsthit/scene_builder.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace firsthit {

/// Makes each texture once. Where a picture cannot be had the scene gets a warning, and the texture's number is
/// -1: none.
class MtlTextures {
  public:
    explicit MtlTextures(SceneBuilder& scene) : scene_(scene) {}

    /// The folder that names are relative to from now on: that of the library.
    void set_folder(std::filesystem::path folder) { folder_ = std::move(folder); }

    /// A picture as it is: colours, or data.
    std::int32_t number(const MtlMap& map, Encoding encoding);

    struct Opacity {
        std::int32_t number = -1;
        bool is_mask = false; // at least nine tenths of it are nearly clear or nearly opaque
    };
    /// A picture of which the alpha is the opacity: the channel that the map names; else the picture's own alpha
    /// where it is not 1 everywhere, and else its brightness.
    Opacity opacity(const MtlMap& map);

    /// A picture with roughness in green and metallic in blue, from one picture of each, by their
    /// brightness; from one picture as it is where it serves both. What is missing is 1.
    std::int32_t metallic_roughness(const MtlMap& roughness, const MtlMap& metallic);

  private:
    /// Warns where the file cannot be read or decoded, once.
    void read_file(const MtlMap& map,
        const std::function<void(const std::string& path, const std::string& bytes)>& decode);
    std::optional<Picture> read(const MtlMap& map);
    std::int32_t add(const MtlMap& map, const Picture& picture, Encoding encoding);
    std::int32_t add(const MtlMap& map, Texture texture);
    std::int32_t once(const std::string& key, const std::function<std::int32_t()>& make);
    std::string key_of(const MtlMap& map) const;

    SceneBuilder& scene_;
    std::filesystem::path folder_;
    std::map<std::string, std::int32_t> number_; // by kind, path and what else matters
    std::map<std::string, bool> is_mask_;
    std::map<std::string, bool> failed_; // paths that were warned of
};

} // namespace firsthit
