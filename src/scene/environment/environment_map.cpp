// environment_map.cpp - an environment, prefiltered when it is made.
#include "scene/environment/prefilter.h"

#include <firsthit/environment.h>
#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit {
namespace {

constexpr int kLeastSide = 16;  // of any level, texels
constexpr int kMostSide = 1024; // of level 0
constexpr int kMostRough = 256; // of the others: a lobe of roughness 1/7 is wider than its texels

/// The side of an octahedron whose texels are about as large as a picture's pixels.
int side_of(int height)
{
    int side = kLeastSide;
    while (side < height && side < kMostSide) side *= 2;
    return side;
}

float usable(float x)
{
    return x > 0 ? std::min(x, EnvironmentMap::kMaxRadiance) : 0.0f;
}

} // namespace

EnvironmentMap::EnvironmentMap(
    std::string name, int width, int height, std::span<const glm::vec3> radiance)
    : name_(std::move(name))
{
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
        std::int64_t(width) * height > kMaxPixels)
        throw ArgumentError(
            fmt::format("environment '{}': {} x {} pixels: accepted are sides of 1 to {} and {} "
                        "pixels in all",
                name_, width, height, kMaxSide, kMaxPixels));
    if (radiance.size() != std::size_t(width) * std::size_t(height))
        throw ArgumentError(fmt::format("environment '{}': {} values for {} x {} pixels", name_,
            radiance.size(), width, height));
    std::vector<glm::vec3> light;
    light.reserve(radiance.size());
    for (const glm::vec3& v : radiance) light.emplace_back(usable(v.x), usable(v.y), usable(v.z));
    const Panorama panorama{width, height, light};
    diffuse_ = diffuse_terms(panorama);

    const int finest = side_of(height);
    std::int32_t next = 0;
    for (int k = 0; k < kLevels; ++k) {
        const int rough =
            std::max(kLeastSide, std::min(kMostRough, finest / 2) >> std::max(k - 1, 0));
        const auto level = std::size_t(k);
        side_[level] = k == 0 ? finest : rough;
        first_[level] = next;
        next += (side_[level] + 2) * (side_[level] + 2);
    }
    table_ = next;
    texel_.resize(std::size_t(next));
    const auto level = [&](std::size_t k) {
        const auto texels = std::size_t(side_[k] + 2) * std::size_t(side_[k] + 2);
        return OctahedronTexels{
            std::span(texel_).subspan(std::size_t(first_[k]), texels), side_[k]};
    };
    unfold(panorama, level(0));
    const OctahedronLevels source(level(0));
    for (std::size_t k = 1; k < kLevels; ++k)
        prefilter(source, double(k) / (kLevels - 1), level(k));
    const std::vector<glm::vec4> shares = reflected_shares(kTableSide);
    texel_.insert(texel_.end(), shares.begin(), shares.end());
}

} // namespace firsthit
