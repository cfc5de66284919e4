// check_settings.h - refuses what cannot be rendered, with what is accepted.
#pragma once

#include <firsthit/render.h>

namespace firsthit {

/// Returns the view with its region filled in.
/// throws  ArgumentError: a size, region, sample count, tile size or camera out of range
View checked(const View& view);
void check(const Settings& settings);

} // namespace firsthit
