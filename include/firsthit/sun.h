// sun.h - where the sun stands at a place and time.
#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace firsthit {

/// The sun in the sky of an observer.
struct SunPosition {
    double azimuth_rad = 0;   // from north, clockwise: pi / 2 is east; 0 to 2 pi
    double elevation_rad = 0; // above the horizon, of the disc's middle, without refraction
};

/// Where the sun stands, to about 0.01 degrees in the years 1900 to 2100.
///
/// latitude_deg   -90 to 90, north is positive
/// longitude_deg  -180 to 180, east is positive
/// unix_s         seconds since 1970-01-01T00:00:00Z, of the years 1800 to 2200
/// throws  ArgumentError: a number out of range
/// source  Meeus 1998, Astronomical Algorithms, chapters 12, 22 and 25 (low accuracy), as NOAA's solar
///         calculator has them
SunPosition sun_position(double latitude_deg, double longitude_deg, double unix_s);

/// The unit direction from the ground to the sun: x east, y up, z south, as in a world with y up.
glm::dvec3 to_sun(const SunPosition& sun);

/// Seconds since 1970 of a time in ISO 8601 with its zone: 2026-06-21T12:00Z, 2026-06-21T14:00:30.5+02:00.
/// throws  ArgumentError: another form, no zone, no such day or hour, or a year that is not 1800 to 2200
double unix_time(const std::string& text);

} // namespace firsthit
