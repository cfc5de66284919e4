// studio.h - light and background for scenes that bring none.
#pragma once

#include <firsthit/options/sky_options.h>
#include <firsthit/scene.h>

namespace firsthit {

/// Whether lights of the scene's own shine on it. The one that readers give to scenes without lights does not count.
bool has_own_lights(const Scene& scene);

/// Puts a scene into a studio: one key light that hangs on the camera and shines from the upper left, and a
/// grey background in the place of a black one. Lights that the scene has are removed. Render it with
/// studio_sky(), which has the rest of the light: together they keep white surfaces below 1.
///
/// Phong materials lose their ambient colour, as far as it is not more than the diffuse one: the sky is in
/// its place. Surfaces that reflect an environment keep it, and the sky only dims it in hollows.
///
/// sky  false: there is no sky. Then the ambient light stays
void set_up_studio(Scene& scene, bool sky = true);

/// The sky of the studio, white, over the camera.
Sky studio_sky();

} // namespace firsthit
