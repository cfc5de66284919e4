// one_light.h - the light of scenes that are measured.
#pragma once

#include <firsthit/scene.h>

namespace firsthit::cli::bench {

/// How files without normals are read: smooth everywhere, so that vertices are not split.
inline const LoadSettings kSmooth{.crease_angle_rad = 3.14159265358979323846};

/// Leaves a scene its first light. A light that goes with the camera becomes a point light that stands in
/// the world, behind the viewer's right shoulder: shadows of a point are what the paper measures.
void leave_one_light(Scene& scene);

} // namespace firsthit::cli::bench
