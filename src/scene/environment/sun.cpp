// sun.cpp - where the sun stands at a place and time.
//
// source  Meeus 1998, Astronomical Algorithms, 2nd edition: chapter 12 (sidereal time), 22 (obliquity), 25 (low
//         accuracy position of the sun); the same formulas are in NOAA's solar calculator
#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kDay_s = 86400;
constexpr double kUnixEpochDay = 2440587.5; // Julian day of 1970-01-01T00:00Z
constexpr double kJ2000Day = 2451545.0;

double wrapped(double degrees)
{
    return degrees - 360 * std::floor(degrees / 360);
}

/// Right ascension and declination, apparent, in radians.
struct Equatorial {
    double right_ascension, declination;
};

/// t  Julian centuries since J2000, dynamical time
Equatorial sun_of(double t)
{
    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = (357.52911 + t * (35999.05029 - t * 0.0001537)) * kDegree;
    const double center = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                          (0.019993 - t * 0.000101) * std::sin(2 * anomaly) +
                          0.000289 * std::sin(3 * anomaly);
    const double node = (125.04 - 1934.136 * t) * kDegree;
    const double longitude =
        (mean_longitude + center - 0.00569 - 0.00478 * std::sin(node)) * kDegree;
    const double obliquity =
        (23.43929111 - t * (0.0130041667 + t * (1.638889e-7 - t * 5.036111e-7)) +
            0.00256 * std::cos(node)) *
        kDegree;
    return {std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)),
        std::asin(std::sin(obliquity) * std::sin(longitude))};
}

/// Greenwich sidereal time in degrees, with the nutation of the low accuracy formulas.
double sidereal_deg(double days, double t)
{
    const double mean =
        280.46061837 + 360.98564736629 * days + t * t * (0.000387933 - t / 38710000);
    const double node = (125.04 - 1934.136 * t) * kDegree;
    return mean - 0.00478 * std::sin(node) * std::cos(23.44 * kDegree);
}

/// How far dynamical time is ahead of the clocks' in the decades around 2000: the sun moves 0.001 degrees
/// meanwhile, so that a constant does.
constexpr double kAhead_s = 65;

} // namespace

SunPosition sun_position(double latitude_deg, double longitude_deg, double unix_s)
{
    if (!(std::abs(latitude_deg) <= 90))
        throw ArgumentError(
            fmt::format("latitude {} is out of range: -90 to 90 degrees", latitude_deg));
    if (!(std::abs(longitude_deg) <= 180))
        throw ArgumentError(
            fmt::format("longitude {} is out of range: -180 to 180 degrees", longitude_deg));
    constexpr double kFrom = -5364662400, kTo = 7289654400; // 1800 to 2200, whole years
    if (!(kFrom <= unix_s && unix_s <= kTo))
        throw ArgumentError(
            fmt::format("time {} s is out of range: the years 1800 to 2200", unix_s));
    const double days = unix_s / kDay_s + kUnixEpochDay - kJ2000Day;
    const Equatorial sun = sun_of((days + kAhead_s / kDay_s) / 36525);
    const double hour_angle =
        wrapped(sidereal_deg(days, days / 36525) + longitude_deg) * kDegree - sun.right_ascension;
    const double latitude = latitude_deg * kDegree;
    const double east = -std::cos(sun.declination) * std::sin(hour_angle);
    const double north = std::sin(sun.declination) * std::cos(latitude) -
                         std::cos(sun.declination) * std::sin(latitude) * std::cos(hour_angle);
    const double up = std::sin(sun.declination) * std::sin(latitude) +
                      std::cos(sun.declination) * std::cos(latitude) * std::cos(hour_angle);
    double azimuth = std::atan2(east, north);
    if (azimuth < 0) azimuth += 2 * std::numbers::pi;
    return {azimuth, std::atan2(up, std::hypot(east, north))};
}

glm::dvec3 to_sun(const SunPosition& sun)
{
    const double level = std::cos(sun.elevation_rad);
    return {level * std::sin(sun.azimuth_rad), std::sin(sun.elevation_rad),
        -level * std::cos(sun.azimuth_rad)};
}

} // namespace firsthit
