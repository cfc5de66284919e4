// careful_hit.h - hits of a triangle for which plain double arithmetic is not precise enough.
//
// The resolve stage computes t = volume / det, u = edge1 / det and v = edge2 / det in double, with
// N from differences of corners. That can lose more digits than float has where the sizes of the
// corners are many octaves apart, or where the eye is close to the triangle's plane.
#pragma once

#include "exact/hit.h"

#include <glm/vec3.hpp>

#include <array>

namespace firsthit {

/// A sum of products whose terms have at most 8 roundings is precise enough if the sum of the
/// terms' sizes is at most this many times the sum: then its relative error is at most 2^-26.
inline constexpr double kMostLost = 0x1p24;

/// One triangle, prepared for the rays that hit it.
///
/// limits  corners must be usable, and rays must hit the triangle
class CarefulHit {
  public:
    explicit CarefulHit(const Corners& corners);

    /// Which results of plain double arithmetic are precise enough.
    struct Plain {
        bool depth = false;   // within one unit in the last place of float
        bool weights = false; // u and v within 2^-25, half a unit in the last place of 1 as float
    };
    Plain plain(const glm::vec3& d) const;

    double depth(const glm::vec3& d) const;                  // relative error below 2^-25
    std::array<double, 2> weights(const glm::vec3& d) const; // u and v, with the same precision

    int eye_side() const { return (volume_ > 0) - (volume_ < 0); } // volume_sign, exact
    const glm::dvec3& n() const { return n_; }                     // (v1 - v0) x (v2 - v0)
    double volume() const { return volume_; }                      // v0 . n

  private:
    Corners corners_;
    glm::dvec3 edge1_, edge2_;          // v2 x v0, v0 x v1: one rounding for each component
    glm::dvec3 plain_n_, plain_n_size_; // N from rounded differences; sizes that bound its error
    bool plain_volume_;                 // v0 . (v1 x v2) in plain double is precise enough
    glm::dvec3 n_;                      // N to within two roundings
    double volume_;
};

} // namespace firsthit
