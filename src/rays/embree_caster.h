// embree_caster.h - Embree 3 as a second oracle, and as the baseline in benchmarks.
#pragma once

#include "base/tasks.h"
#include "rays/brute.h"

#include <memory>

namespace firsthit {

/// Embree's bounding volume hierarchy over triangles in eye space. All rays start at the origin.
class EmbreeCaster {
  public:
    /// triangles  their cut-outs, if any, have to outlive this
    /// robust   use Embree's robust traversal, for comparisons
    /// dynamic  allow refit()
    /// throws   DeviceError: no device, or out of memory
    EmbreeCaster(const EyeTriangles& triangles, bool robust, bool dynamic, int threads);
    ~EmbreeCaster();

    /// Refits the hierarchy to moved corners. Requires `dynamic`.
    void refit(const EyeTriangles& triangles);

    /// Finds the nearest triangle for every ray of the pencil, by coherent packets of 4x2 rays. t
    /// may be empty.
    void cast(
        const Pencil& pencil, std::span<std::uint32_t> items, std::span<float> t, Tasks& tasks);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
