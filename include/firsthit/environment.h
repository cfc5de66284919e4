// environment.h - light that comes from all around.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// The light that arrives from every direction, and what surfaces make of it: prefiltered when it is
/// made, immutable afterwards. Linear Rec.709.
///
/// source  Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment
///         Maps" (diffuse); Karis 2013, "Real Shading in Unreal Engine 4" (specular)
class EnvironmentMap {
  public:
    static constexpr int kMaxSide = 16384;      // largest width or height of a picture
    static constexpr int kMaxPixels = 1 << 26;  // most pixels of a picture
    static constexpr float kMaxRadiance = 1e9f; // brighter pixels are taken to be as bright as this
    static constexpr int kLevels = 8;           // of roughness 0, 1/7, 2/7, ..., 1
    static constexpr int kTableSide = 32;       // of the table of specular reflectance

    /// An equirectangular picture, twice as wide as high in most files. Row 0 is above (+y). The middle
    /// column lies along -z, and +x is a quarter of the width to its right.
    /// radiance  (height, width), values below 0 or not finite count as 0
    /// throws    ArgumentError: another number of values than height x width; a side below 1 or above
    ///           kMaxSide; more than kMaxPixels
    EnvironmentMap(std::string name, int width, int height, std::span<const glm::vec3> radiance);

    /// The name, for messages.
    const std::string& name() const { return name_; }

    /// Diffuse light: a matt white surface of unit normal n = (x, y, z) sends to the eye
    ///     c0 + c1 y + c2 z + c3 x + c4 x y + c5 y z + c6 (3 z z - 1) + c7 x z + c8 (x x - y y)
    const std::array<glm::vec3, 9>& diffuse() const { return diffuse_; }

    /// Specular light: all levels, one after the other, and behind them the table. Each level is a
    /// square of (side + 2) x (side + 2) texels on which the directions are unfolded from an octahedron
    /// (src/glsl/environment.glsl), with a border of one texel that continues it. Level k is what a
    /// surface of roughness k / 7 reflects from around the mirror's direction, and level 0 is the
    /// environment itself. The fourth value is 0.
    /// The table is (kTableSide, kTableSide) by roughness and cosine to the eye: a and b, of which f0
    /// a + f90 b is the share that is reflected.
    std::span<const glm::vec4> texels() const { return texel_; }

    /// The side of each level without its border, texels.
    const std::array<std::int32_t, kLevels>& sides() const { return side_; }
    /// The index in texels() of each level's first texel, in the corner of its border.
    const std::array<std::int32_t, kLevels>& first() const { return first_; }
    /// The index in texels() of the table.
    std::int32_t table() const { return table_; }

  private:
    std::string name_;
    std::array<glm::vec3, 9> diffuse_{};
    std::array<std::int32_t, kLevels> side_{};
    std::array<std::int32_t, kLevels> first_{};
    std::int32_t table_ = 0;
    std::vector<glm::vec4> texel_;
};

/// The environment of a scene. Surfaces of the model MetallicRoughness reflect it, unshadowed but for
/// their occlusion texture, in the place of Scene::ambient. Other models do not see it.
struct Environment {
    std::shared_ptr<const EnvironmentMap> map{}; // none: there is no environment
    double rotation_rad = 0; // turns it about +y, counter-clockwise seen from above; finite
    float strength = 1;      // multiplies its light, 0 or more
    bool background = false; // shows it where nothing is seen, in the place of Scene::background
};

/// Reads an equirectangular picture: .hdr (Radiance) or .exr (scan lines or tiles, R G B).
/// throws  FileError: missing, unreadable, damaged, another format, too large
///         ArgumentError: another ending
std::shared_ptr<const EnvironmentMap> load_environment(const std::string& path);

/// The same light from everywhere.
std::shared_ptr<const EnvironmentMap> constant_environment(const glm::vec3& radiance);

/// A neutral studio, of a bright ceiling, soft boxes and a darker floor: what metals need to look like
/// metals. The reader gives it to glTF scenes with metallic-roughness materials.
std::shared_ptr<const EnvironmentMap> studio_environment();

} // namespace firsthit
