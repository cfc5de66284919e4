// cast_rays.h - what rays hit, by a RayTree: the answers of a loop over all triangles with the predicates of
// exact/ray_hit.h, found faster.
#pragma once

#include "exact/cutouts.h"
#include "rays/tree/ray_tree.h"

#include <firsthit/ray.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// What rays are cast at.
struct CastTarget {
    const RayTree& tree;
    const Scene& scene;     // of the triangles, for cut-outs
    const Cutouts& cutouts; // with kSeenOpacity
};

/// The nearest hit of each ray; of equally near ones the triangle with the lowest id.
void cast_nearest(const CastTarget& target, std::span<const Ray> rays, std::span<RayHit> hits);

/// Whether each ray hits anything: 1 or 0.
void cast_any(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint8_t> is_hit);

/// How many triangles each ray hits.
void cast_count(
    const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count);

/// Appends all hits of each ray, in the order of t, then of id, ray by ray; count receives how many of each.
void cast_all(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count,
    std::vector<RayHit>& hits);

} // namespace firsthit
