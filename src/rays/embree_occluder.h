// embree_occluder.h - Embree 3 as a second oracle of shadows, and as the baseline in benchmarks.
#pragma once

#include "rays/brute_shadows.h"

#include <memory>

namespace firsthit {

/// Embree's bounding volume hierarchy over triangles in a light's space. Rays start at the light:
/// at the origin, or for a directional light parallel to z from in front of the scene.
class EmbreeOccluder {
  public:
    /// triangles  have to outlive this
    /// threads  for building the hierarchy
    /// throws   DeviceError: no device, or out of memory
    EmbreeOccluder(const LightTriangles& triangles, bool robust, int threads);
    ~EmbreeOccluder();

    /// Writes shadowed[k] = 1 where Embree finds a triangle other than the receiver between the
    /// light and points[k], else 0; 0 also where the point has no shadow ray. Casts coherent
    /// packets of eight rays, so consecutive points should be near each other.
    /// points     (N) in the light's space
    /// receivers  (N) triangles to skip; empty: nothing is skipped, which is faster
    /// short_of   fraction of each ray before its point that is left out, so that triangles within
    ///            a few roundings of the point do not count
    void test(const PencilSpace& space, std::span<const glm::vec3> points,
        std::span<const std::uint32_t> receivers, std::span<std::uint8_t> shadowed, Tasks& tasks,
        float short_of = 0x1p-20f);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
