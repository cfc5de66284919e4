// careful_hit.h - where rays hit a triangle of which plain doubles may lose more than float has.
//
// Resolve finds t = volume / det and u = edge1 / det, v = edge2 / det in double, with N from differences of
// corners. That loses digits where corners are many octaves apart, or where the eye is next to the plane.
#pragma once

#include "exact/hit.h"

#include <glm/vec3.hpp>

#include <array>

namespace firsthit {

/// A sum of products that carries at most 8 roundings of kUlp for the size of its terms is precise enough
/// where it is not smaller than its terms by more than this: it is off by 2^-26 of itself at most.
inline constexpr double kMostLost = 0x1p24;

/// What is known of one triangle, for the rays through it.
///
/// limits  rays that hit the triangle; usable corners
class CarefulHit {
  public:
    explicit CarefulHit(const Corners& corners);

    /// Whether what plain doubles say is precise enough.
    struct Plain {
        bool depth = false;   // within one unit in the last place of float
        bool weights = false; // u and v are within 2^-25, which is half of such a unit of 1
    };
    Plain plain(const glm::vec3& d) const;

    double depth(const glm::vec3& d) const;                  // relative error below 2^-25
    std::array<double, 2> weights(const glm::vec3& d) const; // u and v, as precise

    int eye_side() const { return (volume_ > 0) - (volume_ < 0); } // volume_sign, exact
    const glm::dvec3& n() const { return n_; }                     // (v1 - v0) x (v2 - v0)
    double volume() const { return volume_; }                      // v0 . n

  private:
    Corners corners_;
    glm::dvec3 edge1_, edge2_;          // v2 x v0, v0 x v1: a rounding each
    glm::dvec3 plain_n_, plain_n_size_; // of rounded differences, and what bounds its error
    bool plain_volume_;                 // v0 . (v1 x v2) in plain doubles is precise enough
    glm::dvec3 n_;                      // two roundings from the exact one
    double volume_;
};

} // namespace firsthit
