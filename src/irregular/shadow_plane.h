// shadow_plane.h - is a point certainly behind a triangle's plane, as shadows ask it, or certainly
// not?
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace firsthit {

/// What a filter says.
enum class Verdict { undecided, shadowed, lit };

/// A triangle's plane in a light's face. In double, for samples whose coordinates are single
/// roundings (samples.h); divided by what is positive, is_shadowed asks whether
///
///     w of the plane - w of the sample > K s    K = |N| / |N . v0| or, for parallel light, |N| / |N.z|
///
/// with |N| = |N.x| + |N.y| + |N.z| and s the margins over the point's c (1 for parallel light).
class ShadowPlane {
  public:
    ShadowPlane(const PencilMesh& mesh, std::uint32_t triangle);

    /// For a sample whose ray hits the triangle.
    Verdict classify(float x, float y, float w) const;

  private:
    bool directional_;
    double reach_;
    double x_ = 0, y_ = 0;   // where the slopes start
    double wx_ = 0, wy_ = 0; // slopes of w
    double wc_ = 0;          // w there
    double ex_ = 0, ey_ = 0; // error of the plane's w: ex |x| + ey |y| + ec
    double ec_ = 0;          // infinite: nothing is certain
    double length_ = 0;      // K
    double corner_margin_ = 0;
};

} // namespace firsthit
