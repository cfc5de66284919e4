// check_settings.h - checks the settings and the view of a frame.
#pragma once

#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <cstddef>

namespace firsthit {

/// Checks the settings. Shadow settings are checked for all kinds of shadows, even if they are
/// unused.
/// lights  number of lights of the world
/// throws  ArgumentError: a number of samples, tile size, interleaving, shadow setting or OpenGL
///         setting out of range; exact shadows on the gpu engine; the plane `lit` without lights or
///         with too many
void check(const Settings& settings, std::size_t lights);

/// throws  ArgumentError: a number of directions, a light or an `up` of the sky out of range
void check_sky(const Sky& sky);

/// throws  ArgumentError: interleaving with an environment as background
void check_background(const Scene& scene, const Settings& settings);

/// Returns the view with its region filled in.
/// throws  ArgumentError: a size, region or camera out of range
View checked(const View& view);

} // namespace firsthit
