// ray_caster.h - casts any rays: from anywhere, in any direction. For lidar, line of sight, thickness, inside tests,
// and whatever is no picture of a camera.
#pragma once

#include <firsthit/ray.h>
#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace firsthit {

/// All hits of several rays, one list after the other.
struct RayHitLists {
    std::vector<std::size_t> first; // (N + 1) hits of ray k are first[k] to first[k + 1] - 1
    std::vector<RayHit> hit;        // of each ray in the order of t; where equal, of ids
};

/// Casts rays at posed scenes. Keeps a bounding volume hierarchy, memory and threads from call to call. Not
/// thread-safe: one call at a time.
///
/// Answers are exact: those of real arithmetic on the floats of rays and posed corners, for any scale. They do not
/// depend on threads, instruction sets or the order of triangles. A ray through an edge or corner that triangles of a
/// closed surface share hits exactly one of them. Where several triangles are hit at exactly the same t, the lowest id
/// counts as the nearest. A triangle without area, or one in whose plane the origin lies, is not hit. Both sides of
/// triangles are hit. Materials with an alpha mode are hit where a picture shows them: mask where the opacity reaches
/// the cutoff, blend where there is any.
///
/// The hierarchy is built by the first call with a scene. A later call refits it if positions of the world have changed
/// since (all are compared, which takes about 0.1 ms for 10^5 vertices). Rendering neither builds nor refits any.
///
/// rays    (N) in world space; rays that are near each other are faster one after the other
/// stop    a request for it ends the call soon, with Cancelled
/// throws  ArgumentError: a world that was not posed; a skip that is neither a triangle nor kNoItem
///         Cancelled: a stop was requested; results are incomplete
///
/// source  Wald 2007; Wald, Benthin and Boulos 2008; Ize 2013 (docs/sources.md)
class RayCaster {
  public:
    /// threads  number of threads; 0: one for each core
    explicit RayCaster(int threads = 0);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// The nearest hit of each ray; hits gets (N).
    void nearest(const World& world, std::span<const Ray> rays, std::vector<RayHit>& hits,
        std::stop_token stop = {});

    /// Whether each ray hits anything; occluded gets (N), 1 or 0. Faster than nearest().
    void occluded(const World& world, std::span<const Ray> rays,
        std::vector<std::uint8_t>& occluded, std::stop_token stop = {});

    /// How many triangles each ray hits; count gets (N).
    void count(const World& world, std::span<const Ray> rays, std::vector<std::uint32_t>& count,
        std::stop_token stop = {});

    /// All hits of each ray.
    void all_hits(const World& world, std::span<const Ray> rays, RayHitLists& hits,
        std::stop_token stop = {});

    /// The number of threads, including the caller's.
    int threads() const;

    /// How often this caster has built a hierarchy and refitted one.
    struct Updates {
        std::uint64_t builds = 0; // also those in the place of a refit
        std::uint64_t refits = 0; // also those that ended as a build
    };

    /// Updates since it was made.
    Updates updates() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
