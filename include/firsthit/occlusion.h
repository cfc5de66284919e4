// occlusion.h - which points does a light not reach? For points that are no pixels: sun hours on a
// facade, what can be seen from a place.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace firsthit {

/// Tests sets of points against lights; keeps the memory and the threads that the calls share. One
/// call at a time.
///
/// A point is occluded where a triangle stands between it and the light, exactly as a ray from the
/// light to the point says, and where it lies outside a spot's cone. A point within rounding of a
/// triangle's plane, about 1e-6 of the largest coordinates and distances that take part, is not
/// occluded by that triangle. A point that is not finite, beyond 1e30, or where the light is, is
/// never occluded. Answers do not depend on threads, instruction sets or the order of triangles.
///
/// points     (N) world space, metres
/// receivers  (N) the triangle that each point lies on, which does not occlude it, or kNoItem; or
///            empty: every triangle may. Which side of the triangle the light is on is not asked.
/// throws     ArgumentError: a light whose position, direction or cone is no sound one, a number of
///            receivers other than that of the points, a receiver that is no triangle, 2^32 - 1
///            points or more
///
/// source  as exact shadows: Johnson et al. 2005; Aila and Laine 2004 (docs/sources.md)
class Occlusion {
  public:
    /// threads  0: one for each core
    explicit Occlusion(int threads = 0);
    ~Occlusion();
    Occlusion(const Occlusion&) = delete;
    Occlusion& operator=(const Occlusion&) = delete;

    /// One light: occluded (N) becomes 0 or 1 for each point.
    void test(const World& world, std::span<const glm::vec3> points, const Light& light,
        std::vector<std::uint8_t>& occluded, std::span<const std::uint32_t> receivers = {});

    /// Is given one light's answers, (N) bytes that are 0 or 1, valid during the call.
    using Answers = std::function<void(std::size_t light, std::span<const std::uint8_t> occluded)>;

    /// Many lights, one after the other; memory is that of one light.
    void test(const World& world, std::span<const glm::vec3> points, std::span<const Light> lights,
        const Answers& answers, std::span<const std::uint32_t> receivers = {});

    /// Many lights: bits becomes (L, ceil(N / 8)); bit k (of value 1 << k) of byte j of a light is
    /// point 8 j + k. What fills the last byte is 0.
    void test_packed(const World& world, std::span<const glm::vec3> points,
        std::span<const Light> lights, std::vector<std::uint8_t>& bits,
        std::span<const std::uint32_t> receivers = {});

    /// How many threads it works on, the caller's among them.
    int threads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Bytes that are 0 or 1 as bits: bit k of byte j is values[8 j + k]. bits has ceil(N / 8) bytes.
void pack_bits(std::span<const std::uint8_t> values, std::span<std::uint8_t> bits);

} // namespace firsthit
