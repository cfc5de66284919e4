// light_options_test.cpp - lights and shadows of the command line.
#include "options/light_options.h"
#include "common/usage.h"

#include "message_of.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

LightOptions parse_light_options(const std::string& line)
{
    LightOptions options;
    CLI::App app("test", "render");
    add_light_options(app, options);
    app.parse(line);
    return options;
}

TEST(LightOptions, APointHasAPosition)
{
    const Light light = parse_light("point:-1,2.5,3e2");
    EXPECT_EQ(light.kind, Light::Kind::point);
    EXPECT_EQ(light.position, glm::dvec3(-1, 2.5, 300));
}

TEST(LightOptions, ASpotHasFullAngles)
{
    const Light light = parse_light("spot:1,2,3,0,-4,0,40");
    EXPECT_EQ(light.kind, Light::Kind::spot);
    EXPECT_EQ(light.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(light.direction, glm::dvec3(0, -4, 0));
    EXPECT_DOUBLE_EQ(light.outer_rad, 20 * kDegree);
    EXPECT_EQ(light.inner_rad, 0);
    EXPECT_DOUBLE_EQ(parse_light("spot:1,2,3,0,-4,0,40,30").inner_rad, 15 * kDegree);
    const Light hard = parse_light("spot:1,2,3,0,-4,0,40,40");
    EXPECT_EQ(hard.inner_rad, hard.outer_rad);
}

TEST(LightOptions, ADirectionalLightHasTheWayThatItGoes)
{
    const Light light = parse_light("directional:1,-2,0.5");
    EXPECT_EQ(light.kind, Light::Kind::directional);
    EXPECT_EQ(light.direction, glm::dvec3(1, -2, 0.5));
}

TEST(LightOptions, WhatIsNoLightIsQuotedWithWhatIsAccepted)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_light_options("--light lamp:1,2,3"); }),
        "--light: 'lamp:1,2,3' is no light: accepted are point:x,y,z, "
        "spot:x,y,z,dx,dy,dz,DEG[,INNER], directional:dx,dy,dz and sun:LAT,LON,TIME, then "
        ",color=r,g,b "
        ",intensity=I ,falloff=none|square, as point:0,5,0 or "
        "spot:0,5,0,0,-1,0,40,30,color=1,0.5,0");
    for (const char* text :
        {"", ":", "point", "point:", "point:1,2", "point:1,2,3,4", "point:a,b,c", "point:1,,3",
            "point:1,2,nan", "point:1,2,inf", "Point:1,2,3", "1,2,3", "spot:1,2,3,0,-1,0",
            "spot:1,2,3,0,-1,0,40,30,20", "spot:1,2,3,0,0,0,40", "spot:1,2,3,0,-1,0,0",
            "spot:1,2,3,0,-1,0,180", "spot:1,2,3,0,-1,0,-40", "spot:1,2,3,0,-1,0,40,41",
            "spot:1,2,3,0,-1,0,40,-1", "spot:1,2,3,0,-1,0,5e-324", "directional:0,0,0",
            "directional:1e-200,0,0", "directional:1e200,0,0", "directional:1,2"})
        EXPECT_THROW(parse_light(text), UsageError) << text;
}

TEST(LightOptions, LightsReplaceThoseOfTheScene)
{
    Scene scene;
    scene.lights.resize(3);
    apply(parse_light_options(""), scene);
    EXPECT_EQ(scene.lights.size(), 3u);
    apply(parse_light_options("--light point:1,2,3 --light directional:0,-1,0"), scene);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[1].kind, Light::Kind::directional);
}

TEST(LightOptions, ShadowsAreExactUnlessOtherwiseSaid)
{
    Settings settings;
    apply(parse_light_options(""), settings);
    EXPECT_EQ(settings.shadows, Shadows::automatic);
    apply(parse_light_options("--shadows none"), settings);
    EXPECT_EQ(settings.shadows, Shadows::none);
    EXPECT_EQ(message_of<UsageError>([] { parse_light_options("--shadows soft"); }),
        "--shadows: 'soft' is no kind of shadows: accepted are none, map and exact");
}

TEST(LightOptions, WhatShadowMapsNeedArrives)
{
    Settings settings;
    apply(parse_light_options(
              "--shadows map --shadow-map-size 2048 --shadow-bias 0.5 --shadow-filter 3"),
        settings);
    EXPECT_EQ(settings.shadows, Shadows::map);
    EXPECT_EQ(settings.shadow_map_size, 2048);
    EXPECT_EQ(settings.shadow_bias, 0.5);
    EXPECT_EQ(settings.shadow_filter, 3);
}

TEST(LightOptions, WhatIsNotSaidStaysAsTheSettingsHaveIt)
{
    Settings settings;
    settings.shadow_map_size = 100;
    settings.shadow_bias = 7;
    settings.shadow_filter = 5;
    apply(parse_light_options("--shadows map"), settings);
    EXPECT_EQ(settings.shadow_map_size, 100);
    EXPECT_EQ(settings.shadow_bias, 7);
    EXPECT_EQ(settings.shadow_filter, 5);
}

TEST(LightOptions, NumbersOutOfRangeAreNamedByTheirOption)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_light_options("--shadow-map-size 8"); }),
        "--shadow-map-size: '8' is no integer from 16 to 8192");
    EXPECT_EQ(message_of<UsageError>([] { parse_light_options("--shadow-filter 16"); }),
        "--shadow-filter: '16' is no integer from 1 to 15");
    for (const char* line : {"--shadow-bias -1", "--shadow-bias nan", "--shadow-bias inf",
             "--shadow-map-size 8193", "--shadow-filter 0"})
        EXPECT_THROW(parse_light_options(line), UsageError) << line;
}

TEST(LightOptions, OptionsOfShadowMapsNeedShadowMaps)
{
    EXPECT_EQ(message_of<UsageError>([] { check(parse_light_options("--shadow-bias 0")); }),
        "--shadow-bias is of shadow maps: say --shadows map too");
    EXPECT_THROW(check(parse_light_options("--shadows exact --shadow-filter 3")), UsageError);
    EXPECT_THROW(check(parse_light_options("--shadows none --shadow-map-size 64")), UsageError);
    EXPECT_NO_THROW(check(parse_light_options("--shadows map --shadow-map-size 64")));
}

} // namespace
} // namespace firsthit::cli
