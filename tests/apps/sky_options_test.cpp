// sky_options_test.cpp - the studio and the sky of the command line.
#include "options/sky_options.h"
#include "common/usage.h"

#include "message_of.h"

#include <firsthit/studio.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

SkyOptions parse_line(const std::string& line)
{
    SkyOptions options;
    CLI::App app("test", "render");
    add_sky_options(app, options);
    app.parse(line);
    return options;
}

Sky sky_of(const std::string& line, bool studio)
{
    Settings settings;
    apply(parse_line(line), studio, settings);
    return settings.sky;
}

TEST(SkyOptions, TheStudioHasASkyAndOtherScenesHaveNone)
{
    EXPECT_EQ(sky_of("", true).directions, studio_sky().directions);
    EXPECT_EQ(sky_of("", true).color, studio_sky().color);
    EXPECT_EQ(sky_of("", false).directions, 0);
    EXPECT_EQ(sky_of("--draft", true).directions, 0);
    EXPECT_EQ(sky_of("--sky 0", true).directions, 0);
    EXPECT_EQ(sky_of("--sky 0 --draft", true).directions, 0);
}

TEST(SkyOptions, ASkyHasDirectionsAndAColor)
{
    EXPECT_EQ(sky_of("--sky 20", true).directions, 20);
    EXPECT_EQ(sky_of("--sky 20", true).color, studio_sky().color);
    EXPECT_EQ(sky_of("--sky 20", false).directions, 20);
    EXPECT_GT(sky_of("--sky 20", false).color.x, 0);
    const Sky blue = sky_of("--sky 256,0.25,0.5,1", false);
    EXPECT_EQ(blue.directions, 256);
    EXPECT_EQ(blue.color, glm::vec3(0.25f, 0.5f, 1));
    EXPECT_LT(blue.ground.z, 0.5f);
    EXPECT_EQ(sky_of("--sky 8,0.25,0.5,1", true).color, glm::vec3(0.25f, 0.5f, 1));
}

TEST(SkyOptions, WhatIsNoSkyIsQuoted)
{
    for (const char* text :
        {"", "x", "-1", "257", "1.5", "1e2", "16,", "16,1", "16,1,2", "16,1,2,3,4", "16,-1,0,0",
            "16,nan,0,0", "16,1e7,0,0", "16,red", "16 1 1 1", "99999999999"})
        EXPECT_THROW(parse_sky(text), UsageError) << text;
    EXPECT_EQ(message_of<UsageError>([] { parse_line("--sky 16,-1,0,0"); }),
        "--sky: '-1,0,0' is no colour: accepted are r,g,b, each 0 to 1,000,000");
    EXPECT_EQ(message_of<UsageError>([] { parse_line("--studio maybe"); }),
        "--studio: 'maybe' is neither on nor off");
}

TEST(SkyOptions, WhatContradictsIsRefused)
{
    EXPECT_EQ(message_of<UsageError>([] { check(parse_line("--studio on"), true); }),
        "--studio on has a light of its own, --light gives others: say one");
    EXPECT_EQ(message_of<UsageError>([] { check(parse_line("--draft --sky 3"), false); }),
        "--draft leaves the sky out, --sky adds one: say one");
    EXPECT_NO_THROW(check(parse_line("--studio off --sky 3"), true));
    EXPECT_NO_THROW(check(parse_line("--studio on --draft"), false));
}

TEST(SkyOptions, TheStudioIsForScenesWithoutLights)
{
    Scene dark, bright;
    bright.lights.resize(1);
    EXPECT_TRUE(wants_studio(parse_line(""), dark, false));
    EXPECT_FALSE(wants_studio(parse_line(""), bright, false));
    EXPECT_FALSE(wants_studio(parse_line(""), dark, true)) << "lights of the command line";
    EXPECT_FALSE(wants_studio(parse_line("--studio off"), dark, false));
    EXPECT_TRUE(wants_studio(parse_line("--studio on"), bright, false));
    apply_studio(parse_line(""), bright);
    EXPECT_TRUE(wants_studio(parse_line(""), bright, false)) << "also once it is in it";
}

} // namespace
} // namespace firsthit::cli
