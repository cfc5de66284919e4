// environment_options_test.cpp - the environment and the tone of pictures on the command line.
#include "options/environment_options.h"
#include "common/usage.h"

#include "message_of.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

constexpr double kPi = 3.14159265358979323846;

EnvironmentOptions parse_environment_options(const std::string& line)
{
    EnvironmentOptions options;
    CLI::App app("test", "render");
    add_environment_options(app, options);
    app.parse(line);
    return options;
}

Scene with(const std::string& line, Scene scene = {})
{
    apply(parse_environment_options(line), scene);
    return scene;
}

TEST(EnvironmentOptions, ReplaceWhatWasGiven)
{
    Scene scene;
    scene.environment.map = constant_environment({1, 1, 1});
    scene.environment.strength = 3;
    EXPECT_EQ(with("", scene).environment.map, scene.environment.map);
    EXPECT_EQ(with("", scene).environment.strength, 3);
    EXPECT_EQ(with("--environment none", scene).environment.map, nullptr);
    EXPECT_EQ(with("--environment studio").environment.map->name(), "studio");

    const Environment color =
        with("--environment 0.5,1,2 --environment-rotation 90 --environment-strength 2 "
             "--environment-background on",
            scene)
            .environment;
    EXPECT_NEAR(color.map->diffuse()[0].z, 2, 1e-5);
    EXPECT_NEAR(color.rotation_rad, kPi / 2, 1e-12);
    EXPECT_EQ(color.strength, 2);
    EXPECT_TRUE(color.background);
    EXPECT_FALSE(with("--environment-background off", scene).environment.background);
}

TEST(EnvironmentOptions, TonesArrive)
{
    EXPECT_EQ(parse_environment_options("").tone.map, ToneMap::none);
    EXPECT_EQ(parse_environment_options("").tone.exposure_ev, 0);
    const Tone tone = parse_environment_options("--exposure -1.5 --tonemap aces").tone;
    EXPECT_EQ(tone.exposure_ev, -1.5);
    EXPECT_EQ(tone.map, ToneMap::aces);
    EXPECT_EQ(parse_environment_options("--tonemap khronos-pbr-neutral").tone.map,
        ToneMap::khronos_pbr_neutral);
}

TEST(EnvironmentOptions, SayWhatIsAccepted)
{
    const auto said = [](const std::string& line) {
        return message_of<UsageError>([&] { with(line); });
    };
    const auto expect = [&](const std::string& line, const char* what) {
        EXPECT_NE(said(line).find(what), std::string::npos) << line << ": " << said(line);
    };
    expect("--environment sky", "none of none, studio, a colour r,g,b and a file .hdr or .exr");
    expect("--environment 1,2", "'1,2' is none of");
    expect("--environment -1,0,0", "light is not below 0");
    expect("--environment-strength -1", "out of range: 0 to");
    expect("--environment-background maybe", "neither on nor off");
    expect("--exposure 101", "out of range: -100 to 100");
    expect("--tonemap filmic", "accepted are none, aces and khronos-pbr-neutral");
    expect("--environment-rotation 20", "no environment to change");
    EXPECT_THROW(with("--environment sky.jpg"), ArgumentError);
    EXPECT_THROW(with("--environment missing.hdr"), FileError);
}

} // namespace
} // namespace firsthit::cli
