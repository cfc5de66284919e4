// occlusion.h - finds the points that a light does not reach. For points that are not the hits of a
// picture: for example sun hours on a facade, or what is visible from a position.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace firsthit {

/// Tests sets of points against lights. Keeps memory and threads from call to call. Not
/// thread-safe: one call at a time.
///
/// A point is occluded if a triangle is between it and the light, exactly as a ray from the light
/// to the point decides, or if it is outside a spot's cone. A triangle does not occlude points that
/// are closer to its plane than the rounding errors, about 1e-6 of the largest coordinates and
/// distances that are involved. A point is never occluded if it is not finite, has a coordinate
/// beyond 1e30, or is at the position of the light. Results do not depend on threads, instruction
/// sets or the order of triangles.
///
/// points     (N) world space, metres
/// receivers  (N) id of the triangle that each point lies on, which does not occlude it; kNoItem:
///            none. Or empty: any triangle may occlude any point. The side of the triangle that the
///            light is on is not tested
/// throws     ArgumentError: a light with an invalid position, direction or cone; a number of
///            receivers other than that of the points; a receiver that is not a triangle; 2^32 - 1
///            points or more; a world that was not posed
///
/// source  as exact shadows: Johnson et al. 2005; Aila and Laine 2004 (docs/sources.md)
class Occlusion {
  public:
    /// threads  number of threads; 0: one for each core
    explicit Occlusion(int threads = 0);
    ~Occlusion();
    Occlusion(const Occlusion&) = delete;
    Occlusion& operator=(const Occlusion&) = delete;

    /// Tests one light. occluded (N) receives 1 for each occluded point, else 0.
    void test(const World& world, std::span<const glm::vec3> points, const Light& light,
        std::vector<std::uint8_t>& occluded, std::span<const std::uint32_t> receivers = {});

    /// Receives the result of one light: (N) bytes, 0 or 1, valid during the call.
    using Answers = std::function<void(std::size_t light, std::span<const std::uint8_t> occluded)>;

    /// Tests many lights, one after the other. Needs memory for the results of one light only.
    void test(const World& world, std::span<const glm::vec3> points, std::span<const Light> lights,
        const Answers& answers, std::span<const std::uint32_t> receivers = {});

    /// Tests many lights and packs the results as bits (L, ceil(N / 8)). Bit k (of value 1 << k) of
    /// byte j of a light belongs to point 8 j + k. Unused bits of the last byte are 0.
    void test_packed(const World& world, std::span<const glm::vec3> points,
        std::span<const Light> lights, std::vector<std::uint8_t>& bits,
        std::span<const std::uint32_t> receivers = {});

    /// The number of threads, including the caller's.
    int threads() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Packs bytes that are 0 or 1 into bits: bit k of byte j is values[8 j + k].
/// bits  ceil(N / 8) bytes
void pack_bits(std::span<const std::uint8_t> values, std::span<std::uint8_t> bits);

} // namespace firsthit
