// cutouts.cpp - triangles that are there only where their opacity says so.
#include "exact/cutouts.h"

#include "exact/cutout_opacity.h"
#include "exact/opacity.h"

#include <algorithm>

namespace firsthit {
namespace {

/// The least opacity at which a surface of the material is there.
float cutoff_of(const Material& material, float blend_cutoff)
{
    return material.alpha == AlphaMode::blend ? blend_cutoff : material.alpha_cutoff;
}

/// Whether a surface of the material is there at each of its points.
bool is_solid_everywhere(const Scene& scene, const Material& material, float blend_cutoff)
{
    if (material.alpha == AlphaMode::opaque) return true;
    const bool varies = !scene.color.empty() || material.opacity_texture.texture >= 0;
    return !varies && material.opacity >= cutoff_of(material, blend_cutoff);
}

} // namespace

bool has_cutouts(const Scene& scene)
{
    return std::any_of(
        scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
            return instance.triangle_count > 0 &&
                   !is_solid_everywhere(scene, scene.materials[instance.material], kShadowOpacity);
        });
}

bool has_blended_triangles(const Scene& scene)
{
    return std::any_of(
        scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
            return instance.triangle_count > 0 &&
                   scene.materials[instance.material].alpha == AlphaMode::blend;
        });
}

void Cutouts::find(const Scene& scene, float blend_cutoff)
{
    scene_ = &scene;
    blend_cutoff_ = blend_cutoff;
    parallel_ = false;
    nearest_ = 0;
    word_.clear();
    for (const Instance& instance : scene.instances) {
        if (instance.triangle_count == 0 ||
            is_solid_everywhere(scene, scene.materials[instance.material], blend_cutoff))
            continue;
        if (word_.empty()) word_.resize((scene.index.size() + 63) / 64);
        const std::size_t last = std::size_t(instance.first_triangle) + instance.triangle_count;
        for (std::size_t t = instance.first_triangle; t < last; ++t)
            word_[t / 64] |= std::uint64_t(1) << t % 64;
    }
}

void Cutouts::look_along(
    const Pencil& pencil, std::span<const glm::vec4> corner, std::span<const glm::uvec3> index)
{
    parallel_ = pencil.parallel;
    nearest_ = pencil.nearest;
    const auto is_behind = [&](std::uint32_t vertex) { return !(corner[vertex].z > nearest_); };
    for (std::size_t t = 0; t < index.size(); ++t) {
        const glm::uvec3& c = index[t];
        if (!is_behind(c.x) && !is_behind(c.y) && !is_behind(c.z)) continue;
        if (word_.empty()) word_.resize((index.size() + 63) / 64);
        word_[t / 64] |= std::uint64_t(1) << t % 64;
    }
}

bool is_solid_at(const Scene& scene, std::uint32_t triangle, float u, float v, float blend_cutoff)
{
    const Material& material = scene.materials[scene.instances[scene.owner[triangle]].material];
    return opacity(scene, triangle, u, v) >= cutoff_of(material, blend_cutoff);
}

bool Cutouts::is_solid(std::uint32_t triangle, const Corners& corners, const glm::vec3& d) const
{
    if (nearest_ > 0 && !is_beyond(corners, d, nearest_)) return false;
    const Instance& instance = scene_->instances[scene_->owner[triangle]];
    if (scene_->materials[instance.material].alpha == AlphaMode::opaque) return true;
    const auto [u, v] = weights(corners, d);
    return is_solid_at(*scene_, triangle, u, v, blend_cutoff_);
}

bool is_shadowed(const PencilSpace& space, const Cutouts& cutouts, const OccluderTriangle& occluder,
    const glm::vec3& d, Effort& effort)
{
    const Corners& c = occluder.corners;
    return is_shadowed(space, c, d, effort) &&
           cutouts.is_there(occluder.triangle, weight_corners(space, c), pencil_ray(space, d));
}

} // namespace firsthit
