// check_settings.h - refuses what cannot be rendered, with what is accepted.
#pragma once

#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <cstddef>

namespace firsthit {

/// The shadow settings are checked whatever the kind of shadows, and that the plane `lit` of the
/// lights can be made.
/// throws  ArgumentError: a sample count, tile size or shadow setting out of range; no light, or too
///         many, for `lit`
void check(const Settings& settings, std::size_t lights);

/// Returns the view with its region filled in.
/// throws  ArgumentError: a size, region or camera out of range
View checked(const View& view);

} // namespace firsthit
