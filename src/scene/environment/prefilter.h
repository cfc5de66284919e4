// prefilter.h - what surfaces make of the light from all around, computed ahead.
#pragma once

#include "scene/environment/octahedron.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace firsthit {

/// An equirectangular picture: see EnvironmentMap.
struct Panorama {
    int width = 0, height = 0;
    std::span<const glm::vec3> radiance; // (height, width), finite and not negative
};

/// EnvironmentMap::diffuse() of a picture whose pixels have the same light all over. Exact but for
/// rounding.
std::array<glm::vec3, 9> diffuse_terms(const Panorama& panorama);

/// Fills a level of the octahedron with the picture's light.
void unfold(const Panorama& panorama, const OctahedronTexels& level);

/// A level and its smaller copies, each half as wide, down to 1.
class OctahedronLevels {
  public:
    explicit OctahedronLevels(const OctahedronTexels& finest);

    /// The light from a direction, averaged over about 2^level texels of the finest.
    glm::vec4 light(const glm::vec3& d, int level) const;
    int last() const { return int(level_.size()) - 1; }
    int side() const { return level_[0].side; }

  private:
    std::vector<std::vector<glm::vec4>> memory_;
    std::vector<OctahedronTexels> level_;
};

/// Fills a level with what a surface of a roughness above 0 reflects straight back: the mean of the light
/// around the mirror's direction, weighted by the microfacets that send it there and by n.l.
///
/// source  Karis 2013; Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling"
void prefilter(const OctahedronLevels& source, double roughness, const OctahedronTexels& level);

/// The table of EnvironmentMap::texels(): (side, side) by roughness and cosine to the eye.
///
/// source  Karis 2013 (the split sum); Heitz 2018, "Sampling the GGX Distribution of Visible Normals"
std::vector<glm::vec4> reflected_shares(int side);

} // namespace firsthit
