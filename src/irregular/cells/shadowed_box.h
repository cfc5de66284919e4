// shadowed_box.h - decides whether one triangle, or two that share an edge, certainly shadow
// everything inside a box of the face.
#pragma once

#include "exact/shadow_ray.h"
#include "irregular/mesh/cube_face.h"
#include "irregular/mesh/samples.h"

namespace firsthit {

/// Whether the triangle certainly shadows all points that project to the face inside the bounds and
/// do not lie on the triangle. False where that is not certain.
/// corners  usable, in the pencil's space
bool shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& corners,
    const SampleBounds& bounds);

/// The same for two triangles that share an edge, such as the halves of a quad: each point is
/// shadowed by the one or the other. False if they share no edge.
bool pair_shadows_box(const PencilSpace& space, const CubeFace& face, const Corners& first,
    const Corners& second, const SampleBounds& bounds);

} // namespace firsthit
