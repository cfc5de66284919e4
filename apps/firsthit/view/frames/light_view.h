// light_view.h - the scene as a light sees it, which is what its shadow map holds.
#pragma once

#include "view/frames/box.h"

#include <firsthit/light.h>
#include <firsthit/view.h>

namespace firsthit::cli::view {

/// A camera where a light is, which sees the light's cone, or all of a box: of a point light as much of it as 120
/// degrees hold, and of a directional one from so far away that its rays are nearly parallel.
/// light  in world space
Camera camera_of_light(const Light& light, const Box& box);

} // namespace firsthit::cli::view
