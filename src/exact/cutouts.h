// cutouts.h - triangles that are there only where their opacity says so.
//
// A triangle of a material with AlphaMode::mask is hit, and shadows, where the ray hits it (hit.h,
// shadow_ray.h) and its opacity is at least the material's cutoff. With AlphaMode::blend it is seen
// where it has any opacity (kSeenOpacity), and shadows where its opacity is at least kShadowOpacity.
// These functions are the definition, for the rasteriser, the shadows and the oracles alike.
#pragma once

#include "exact/hit.h"
#include "exact/pencil.h"
#include "exact/shadow_ray.h"

#include <firsthit/scene.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// A surface with AlphaMode::blend is seen where its opacity is at least the one, and shadows where it
/// is at least the other. What has less opacity than the first, has none.
inline constexpr float kSeenOpacity = 0x1p-126f, kShadowOpacity = 0.5f;

/// Whether the scene has triangles that do not shadow everywhere where a ray hits them.
bool has_cutouts(const Scene& scene);

/// Whether the scene has a triangle of a material with AlphaMode::blend.
bool has_blended_triangles(const Scene& scene);

/// The triangles of a scene that need not be everywhere where a ray hits them. All functions but
/// find() may be called at the same time.
class Cutouts {
  public:
    /// Finds them. Costs next to nothing in a scene without any. The scene has to outlive the use.
    /// Allocates only to grow.
    ///
    /// blend_cutoff  kSeenOpacity for what is seen, kShadowOpacity for what shadows
    void find(const Scene& scene, float blend_cutoff);

    /// To be called after find(), for an orthographic camera: the triangles that reach behind its eye become
    /// cut-outs too, which are there only in front of it.
    ///
    /// corner  (V) the vertices in the pencil's eye space; the fourth coordinate is unused
    /// index   (T) of the scene's triangles, or empty
    void look_along(
        const Pencil& pencil, std::span<const glm::vec4> corner, std::span<const glm::uvec3> index);

    /// The weights of corners 1 and 2 at the point where the ray along d hits a triangle, each rounded to
    /// float: rounded_barycentrics, or after look_along() those of parallel rays.
    std::array<float, 2> weights(const Corners& corners, const glm::vec3& d) const
    {
        return parallel_ ? rounded_parallel_barycentrics(corners, d)
                         : rounded_barycentrics(corners, d);
    }

    /// Whether there are any.
    bool any() const { return !word_.empty(); }

    /// Whether the triangle is one of them. Triangles of materials that are opaque at each point of
    /// them are none.
    bool has(std::uint32_t triangle) const
    {
        return !word_.empty() && (word_[triangle / 64] >> triangle % 64 & 1);
    }

    /// Bit t % 64 of word t / 64 is set for triangle t; empty where there are none.
    std::span<const std::uint64_t> words() const { return word_; }

    /// Whether the triangle, one of them, is where the ray along d hits it.
    ///
    /// corners  the triangle's, relative to the ray's origin; the ray has to hit it
    bool is_solid(std::uint32_t triangle, const Corners& corners, const glm::vec3& d) const;

    /// Whether the ray along d, which hits the triangle, hits something that is there.
    bool is_there(std::uint32_t triangle, const Corners& corners, const glm::vec3& d) const
    {
        return !has(triangle) || is_solid(triangle, corners, d);
    }

  private:
    const Scene* scene_ = nullptr;
    bool parallel_ = false; // the rays are those of an orthographic camera
    float nearest_ = 0;     // Pencil::nearest
    float blend_cutoff_ = kShadowOpacity;
    std::vector<std::uint64_t> word_; // (T) a bit for each triangle; empty: none
};

/// A triangle between a light and a point.
struct OccluderTriangle {
    std::uint32_t triangle; // its id
    Corners corners;        // in the light's space
};

/// is_shadowed of shadow_ray.h, where the triangle is there.
bool is_shadowed(const PencilSpace& space, const Cutouts& cutouts, const OccluderTriangle& occluder,
    const glm::vec3& d, Effort& effort);

} // namespace firsthit
