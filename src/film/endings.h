// endings.h - which formats the endings of files stand for, and whether a film has what is to be written.
#pragma once

#include "film/picture_files.h"

#include <firsthit/film.h>

#include <string>
#include <string_view>

namespace firsthit {

/// The path's ending in lower case, such as ".png". A device such as /dev/null has none; returns `of_device`
/// for it.
std::string ending_of(const std::string& path, const char* of_device);

/// The ending that says how a plane is written: `format` unless it is empty, else the path's.
/// throws  ArgumentError: another ending, or .png for a plane that is no distance
std::string plane_ending(Aov aov, const std::string& path, const std::string& format);

/// throws  ArgumentError where the plane is not (height, width, channels)
void check_shape(const Film& film, const PlaneView& plane, std::string_view name);

} // namespace firsthit
