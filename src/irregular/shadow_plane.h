// shadow_plane.h - decides in double whether a point is behind a triangle's plane, where that is
// certain.
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace firsthit {

/// What a filter knows of a point: lit means that this triangle does not shadow it.
enum class Verdict { undecided, shadowed, lit };

/// A triangle's plane in the coordinates of its face (CubeFace). A sample whose ray hits the
/// triangle is shadowed if is_shadowed, divided by positive numbers, says so:
///
///     w(plane) - w(sample) > K s    K = |N| / |N . v0|, in a parallel pencil |N| / |N.z|
///
/// with |N| = |N.x| + |N.y| + |N.z|, and s the margins divided by the point's c (in a parallel
/// pencil, by 1). Computed in double, for samples whose coordinates were rounded once.
class ShadowPlane {
  public:
    ShadowPlane(const PencilMesh& mesh, std::uint32_t triangle);

    /// Whether the triangle shadows a sample whose ray hits it.
    Verdict classify(float x, float y, float w) const;

  private:
    bool directional_;
    double reach_;
    // With x and y relative to (x_, y_), w of the plane is wx_ x + wy_ y + wc_, and its error is at
    // most ex_ |x| + ey_ |y| + ec_. If ec_ is infinite, the verdict is always undecided.
    double x_ = 0, y_ = 0;
    double wx_ = 0, wy_ = 0;
    double wc_ = 0;
    double ex_ = 0, ey_ = 0;
    double ec_ = 0;
    double length_ = 0; // K
    double corner_margin_ = 0;
};

} // namespace firsthit
