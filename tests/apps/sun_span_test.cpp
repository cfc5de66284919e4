// sun_span_test.cpp - the sun over a span of time, and lights with more than a place.
#include "inputs/parse_light.h"
#include "inputs/sun_span.h"
#include "common/usage.h"

#include "message_of.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit::cli {
namespace {

TEST(SunSpan, HasASunInTheMiddleOfEachStep)
{
    const SunSpan span = parse_sun_span("0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,1h");
    const std::vector<SunStep> steps = sun_steps(span, 0);
    ASSERT_EQ(steps.size(), 24u);
    double hours = 0;
    int days = 0;
    for (const SunStep& step : steps) {
        hours += step.hours;
        days += step.direction.has_value();
    }
    EXPECT_DOUBLE_EQ(hours, 24);
    EXPECT_EQ(days, 12) << "an equinox at the equator";
    ASSERT_TRUE(steps[6].direction);
    EXPECT_LT(glm::length(*steps[6].direction - glm::dvec3(-1, 0, 0)), 0.2)
        << "it rises in the east";
    EXPECT_LT(glm::length(*steps[11].direction - glm::dvec3(0, -1, 0)), 0.3) << "noon";
    // North to where east was: the sun rises where south was.
    EXPECT_LT(glm::length(*sun_steps(span, 90)[6].direction - glm::dvec3(0, 0, -1)), 0.2);
}

TEST(SunSpan, TheLastStepMayBeShort)
{
    const std::vector<SunStep> steps =
        sun_steps(parse_sun_span("50,10,2026-06-21T10:00Z,2026-06-21T11:10Z,30m"), 0);
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_DOUBLE_EQ(steps[0].hours, 0.5);
    EXPECT_DOUBLE_EQ(steps[2].hours, 1.0 / 6);
}

TEST(SunSpan, WhatIsNoSpanIsRefused)
{
    for (const char* text : {"", "1,2", "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z",
             "91,0,2026-03-20T00:00Z,2026-03-21T00:00Z,1h",
             "0,nan,2026-03-20T00:00Z,2026-03-21T00:00Z,1h", "0,0,2026-03-20,2026-03-21T00:00Z,1h",
             "0,0,2026-03-21T00:00Z,2026-03-21T00:00Z,1h",
             "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,0s",
             "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,-1h",
             "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,10",
             "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,",
             "0,0,1900-03-20T00:00Z,2026-03-21T00:00Z,1s",
             "0,0,2026-03-20T00:00Z,2026-03-21T00:00Z,h"})
        EXPECT_THROW(parse_sun_span(text), UsageError) << text;
}

TEST(ParseLight, HasColourIntensityAndFalloff)
{
    const Light light = parse_light("point:1,2,3,color=1,0.5,0.25,intensity=4,falloff=square");
    EXPECT_EQ(light.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(light.color, glm::vec3(4, 2, 1));
    EXPECT_TRUE(light.inverse_square);
    EXPECT_FALSE(light.on_camera);
    const Light spot = parse_light("camera:spot:0,0,0,0,0,-1,40,falloff=none,intensity=0.5");
    EXPECT_TRUE(spot.on_camera);
    EXPECT_EQ(spot.color, glm::vec3(0.5f));
    EXPECT_EQ(spot.direction, glm::dvec3(0, 0, -1));
    EXPECT_EQ(parse_light("directional:0,-1,0,color=0,1,0").color, glm::vec3(0, 1, 0));
}

TEST(ParseLight, ASunIsADirection)
{
    // The summer's noon at 52.52 north: 58.1 degrees high at azimuth 149.4 (the ephemeris of sun_test.cpp).
    const Light sun = parse_light("sun:52.52,13.405,2026-06-21T12:00+02:00,color=1,0.9,0.8");
    EXPECT_EQ(sun.kind, Light::Kind::directional);
    const double up = std::sin(58.1455 * 3.14159265358979 / 180);
    EXPECT_NEAR(sun.direction.y, -up, 1e-3);
    EXPECT_LT(sun.direction.x, 0) << "from the east";
    EXPECT_LT(sun.direction.z, 0) << "from the south";
    EXPECT_NE(message_of<UsageError>([] {
        parse_light("sun:52.52,13.405,2026-06-21T00:00+02:00");
    }).find("degrees below the horizon"),
        std::string::npos);
    const Light turned = parse_light("sun:52.52,13.405,2026-06-21T12:00+02:00,north=180");
    EXPECT_LT(glm::length(turned.direction - sun.direction * glm::dvec3(-1, 1, -1)), 1e-12);
}

TEST(ParseLight, UpTurnsWithTheWorld)
{
    const glm::dvec3 d(1, 2, 3);
    EXPECT_EQ(turned_up(d, {0, 1, 0}), d);
    EXPECT_EQ(turned_up(d, {0, 0, 1}), glm::dvec3(1, -3, 2));
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0),
             glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)}) {
        EXPECT_EQ(turned_up({0, 1, 0}, axis), axis);
        const glm::dvec3 x = turned_up({1, 0, 0}, axis), z = turned_up({0, 0, 1}, axis);
        EXPECT_EQ(glm::cross(x, axis), z) << "a rotation";
    }
}

TEST(ParseLight, WhatDoesNotFitIsRefused)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_light("point:0,0,0,colour=1,1,1"); }),
        "'point:0,0,0,colour=1,1,1': 'colour=' is not known here, or given twice: accepted are "
        "color, "
        "intensity, falloff, and north of a sun");
    for (const char* text : {"point:0,0,0,color=1,1", "point:0,0,0,color=-1,1,1",
             "point:0,0,0,color=nan,1,1", "point:0,0,0,color=", "point:0,0,0,intensity=-1",
             "point:0,0,0,intensity=inf", "point:0,0,0,intensity=1,2", "point:0,0,0,falloff=linear",
             "directional:0,-1,0,falloff=square", "point:0,0,0,intensity=1,intensity=2",
             "point:color=1,1,1", "point:0,0,0,north=3", "camera:camera:point:0,0,0",
             "camera:", "camera:sun:52,13,2026-06-21T12:00Z", "sun:52,13",
             "sun:152,13,2026-06-21T12:00Z", "sun:52,13,noon", "sun:52,13,2026-06-21T12:00",
             "point:0,0,0,=1", "point:0,0,0,color=1e9,0,0"})
        EXPECT_THROW(parse_light(text), UsageError) << text;
}

} // namespace
} // namespace firsthit::cli
