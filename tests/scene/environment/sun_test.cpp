// sun_test.cpp - the sun's place against published positions.
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kToDegrees = 180 / std::numbers::pi;

struct Reference {
    double latitude, longitude;
    const char* time;
    double azimuth_deg, elevation_deg; // without refraction
};

TEST(Sun, StandsWhereTheSolarPositionAlgorithmSays)
{
    // Reda and Andreas 2004, "Solar Position Algorithm for Solar Radiation Applications", appendix A.5: azimuth
    // 194.34024, elevation 39.872046 before the correction for refraction.
    const SunPosition sun =
        sun_position(39.742476, -105.1786, unix_time("2003-10-17T12:30:30-07:00"));
    EXPECT_NEAR(sun.azimuth_rad * kToDegrees, 194.34024, 0.01);
    EXPECT_NEAR(sun.elevation_rad * kToDegrees, 39.872046, 0.01);
}

TEST(Sun, StandsWhereAnEphemerisSays)
{
    // PyEphem 4.1 (VSOP87), pressure 0.
    const Reference references[] = {{52.52, 13.405, "2026-06-21T10:00:00Z", 149.3635, 58.1455},
        {52.52, 13.405, "2026-12-21T11:30:00Z", 186.0379, 13.8359},
        {-33.8688, 151.2093, "2026-01-15T02:00:00Z", 4.6589, 77.2388},
        {1.3521, 103.8198, "2026-03-20T05:00:00Z", 116.2813, 86.5858},
        {64.1466, -21.9426, "1999-06-30T23:30:00Z", 332.3094, 0.4450},
        {-77.85, 166.67, "2050-11-05T12:00:00Z", 188.8899, 3.8127},
        {40.4168, -3.7038, "1925-04-10T06:45:00Z", 88.6674, 10.4788},
        {78.2232, 15.6267, "2090-05-17T00:10:00Z", 18.0775, 8.2193}};
    for (const Reference& of : references) {
        const SunPosition sun = sun_position(of.latitude, of.longitude, unix_time(of.time));
        const double level = std::cos(of.elevation_deg / kToDegrees);
        EXPECT_NEAR(sun.elevation_rad * kToDegrees, of.elevation_deg, 0.012) << of.time;
        EXPECT_NEAR((sun.azimuth_rad * kToDegrees - of.azimuth_deg) * level, 0, 0.012) << of.time;
    }
}

TEST(Sun, IsDueSouthOrNorthAtItsHighest)
{
    // Over a day the highest sun is on the meridian, at 90 degrees less the latitude plus the declination.
    for (const double latitude : {60.0, -45.0}) {
        SunPosition highest;
        for (int minute = 0; minute < 1440; ++minute) {
            const SunPosition sun =
                sun_position(latitude, 0, unix_time("2024-06-20T00:00Z") + 60 * minute);
            if (sun.elevation_rad > highest.elevation_rad) highest = sun;
        }
        const double expected = 90 - std::abs(latitude - 23.436);
        EXPECT_NEAR(highest.elevation_rad * kToDegrees, expected, 0.01);
        const double due = latitude > 0 ? 180 : 0;
        EXPECT_NEAR(std::remainder(highest.azimuth_rad * kToDegrees - due, 360), 0, 0.6);
    }
}

TEST(Sun, DirectionsHaveEastUpAndSouth)
{
    EXPECT_LT(glm::length(to_sun({0, 0}) - glm::dvec3(0, 0, -1)), 1e-15) << "north";
    EXPECT_LT(glm::length(to_sun({std::numbers::pi / 2, 0}) - glm::dvec3(1, 0, 0)), 1e-15)
        << "east";
    EXPECT_LT(glm::length(to_sun({1, std::numbers::pi / 2}) - glm::dvec3(0, 1, 0)), 1e-15)
        << "zenith";
}

TEST(Sun, NumbersOutOfRangeAreRefused)
{
    EXPECT_EQ(message_of<ArgumentError>([] { sun_position(91, 0, 0); }),
        "latitude 91 is out of range: -90 to 90 degrees");
    EXPECT_EQ(message_of<ArgumentError>([] { sun_position(0, -181, 0); }),
        "longitude -181 is out of range: -180 to 180 degrees");
    EXPECT_THROW(sun_position(std::nan(""), 0, 0), ArgumentError);
    EXPECT_THROW(sun_position(0, std::nan(""), 0), ArgumentError);
    for (const double time : {std::nan(""), 1e300, -1e300, 1e11})
        EXPECT_THROW(sun_position(0, 0, time), ArgumentError);
}

} // namespace
} // namespace firsthit
