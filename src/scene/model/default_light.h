// default_light.h - light for scenes that bring none.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Adds one white point light where a viewer expects it: behind the camera's shoulder, up and to
/// the right. From the eye it stands off by 0.5 to the camera's right and 0.7 up, times the
/// distance from the eye to the middle of the scene as it is posed at its start.
void add_default_light(Scene& scene);

} // namespace firsthit
