// default_light.h - light for scenes that bring none.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Whether a material reflects as metals and dielectrics do, and so has light from all around to show.
bool has_physical_materials(const Scene& scene);

/// Adds one white light that goes with the camera: from far away, over the viewer's left shoulder, so
/// that what is seen is lit from whatever side it is looked at.
void add_default_light(Scene& scene);

/// Whether it is the light of add_default_light.
bool is_default_light(const Light& light);

} // namespace firsthit
