// world_parts.h - parts of a posed world, each as a world of its own.
#pragma once

#include <firsthit/render.h>
#include <firsthit/scene.h>
#include <firsthit/view.h>
#include <firsthit/world.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace firsthit {

/// Takes parts out of a posed world: worlds that have some of its instances, at the same places, and
/// nothing else. Their items and cut-outs are those of the whole world where nothing stands before
/// them. They have no lights, and no textures but those that say where a surface is.
class WorldParts {
  public:
    /// world  posed; has to outlive the parts and stay as it is
    /// throws  ArgumentError: the world has no scene
    explicit WorldParts(const World& world);

    /// The world of some instances. Their triangles have ids from 0, in the order of `instances`. It
    /// stays valid until the next call. Costs as much as its own vertices and triangles.
    ///
    /// instances  of Scene::instances
    /// throws  ArgumentError: there is no such instance
    const World& part(std::span<const std::uint32_t> instances);

  private:
    const World& whole_;
    World part_;
    std::shared_ptr<Scene> scene_; // of part_
};

/// A rectangle of the view's pixels outside of which no ray meets the world. Nothing where no ray does
/// for certain. It may be larger than what is seen.
/// throws  as Renderer::render, for the camera
std::optional<Region> region_that_sees(const World& world, const View& view);

/// How many of the view's pixels would see each part if it was alone in the world: of rays through
/// their centres, exact. Blended surfaces are seen where they have any opacity.
///
/// parts  instances of each part
/// throws  as WorldParts and Renderer::render
std::vector<std::uint64_t> pixels_alone(Renderer& renderer, const World& world, const View& view,
    std::span<const std::vector<std::uint32_t>> parts);

} // namespace firsthit
