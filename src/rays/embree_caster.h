// embree_caster.h - Embree 3 as a second oracle, and as the baseline in benchmarks.
#pragma once

#include "base/tasks.h"
#include "rays/brute.h"

#include <memory>

namespace firsthit {

/// A bounding volume hierarchy over triangles in eye space, whose rays start at the origin.
class EmbreeCaster {
  public:
    /// robust   Embree's robust traversal, for comparisons
    /// dynamic  keeps its tree, refit() brings it up to date
    /// throws   DeviceError: no device, or out of memory
    EmbreeCaster(const EyeTriangles& triangles, bool robust, bool dynamic, int threads);
    ~EmbreeCaster();

    /// Refits the tree to moved corners.
    void refit(const EyeTriangles& triangles);

    /// Nearest triangle for every ray of the pencil, 4x2 rays a packet, coherent. t may be empty.
    void cast(
        const Pencil& pencil, std::span<std::uint32_t> items, std::span<float> t, Tasks& tasks);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
