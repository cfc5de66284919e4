// default_material.h - what triangles look like that come without a material.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Ambient light of scenes that come without lights. Exporters write `Ka 1 1 1` as often as they
/// leave it out, and mean no more by it than that the material has a colour.
inline constexpr float kMeshAmbient = 0.18f;

/// The material of a triangle without one: neutral grey.
Material default_material();

} // namespace firsthit
