// shadowed_box.h - does a triangle certainly shadow everything in a box?
#pragma once

#include "exact/shadow_ray.h"
#include "visibility/irregular_samples.h"
#include "visibility/light_face.h"

namespace firsthit {

/// Whether the triangle (usable corners in the light's space) certainly shadows all points inside the
/// bounds, as the face sees them, that do not lie on it. False where that is not known.
bool shadows_box(const LightSpace& space, const LightFace& face, const Corners& corners,
    const SampleBounds& bounds);

} // namespace firsthit
