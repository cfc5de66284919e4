// shadowed_box.h - does a triangle certainly shadow everything in a box, or do two?
#pragma once

#include "exact/shadow_ray.h"
#include "irregular/mesh/cube_face.h"
#include "irregular/mesh/samples.h"

namespace firsthit {

/// Whether the triangle (usable corners in the light's space) certainly shadows all points inside the
/// bounds, as the face sees them, that do not lie on it. False where that is not known.
bool shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& corners,
    const SampleBounds& bounds);

/// The same for two triangles that share an edge, where each point is in the shadow of one of them: as
/// behind a wall of two. False where they share none.
bool pair_shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& first,
    const Corners& second, const SampleBounds& bounds);

} // namespace firsthit
