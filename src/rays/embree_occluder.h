// embree_occluder.h - Embree 3 as a second oracle of shadows, and as the baseline in benchmarks.
#pragma once

#include "rays/brute_shadows.h"

#include <memory>

namespace firsthit {

/// A bounding volume hierarchy over triangles in a light's space. Its rays come from the light: from
/// the origin, or parallel to z from before everything.
class EmbreeOccluder {
  public:
    /// threads  of building
    /// throws   DeviceError: no device, or out of memory
    EmbreeOccluder(const LightTriangles& triangles, bool robust, int threads);
    ~EmbreeOccluder();

    /// shadowed[k] = 1 where Embree finds a triangle other than the receiver between the light and
    /// points[k], 0 elsewhere and where the point has no shadow ray. Eight rays a packet, coherent:
    /// give points in an order in which neighbours are near each other. What lies within a few
    /// roundings of the point does not count: `short_of` is the share of the ray that is left out.
    /// points     (N) in the light's space
    /// receivers  (N), or empty: nothing is skipped, which is quicker
    void test(const PencilSpace& space, std::span<const glm::vec3> points,
        std::span<const std::uint32_t> receivers, std::span<std::uint8_t> shadowed, Tasks& tasks,
        float short_of = 0x1p-20f);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
