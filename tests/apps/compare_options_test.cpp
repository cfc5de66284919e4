// compare_options_test.cpp - the command line of `compare`, before any scene is loaded.
#include "compare_command.h"
#include "common/usage.h"

#include "message_of.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

CompareOptions parse_compare_options(const std::string& line)
{
    CompareOptions options;
    CLI::App app("test", "compare");
    add_compare_options(app, options);
    app.parse(line);
    return options;
}

TEST(CompareOptions, AnEngineOnOpenGlArrives)
{
    const CompareOptions options =
        parse_compare_options("s --against cpu --engine hybrid --multisample full5 "
                              "--item-format rgb8 --depth-format fixed24 --shadows none "
                              "--interleave 4 --no-interpolate --json");
    EXPECT_FALSE(options.oracle);
    EXPECT_EQ(options.engine.engine, Engine::hybrid);
    EXPECT_EQ(options.engine.multisample, Multisample::full5);
    EXPECT_EQ(options.engine.opengl.item_format, ItemFormat::rgb8);
    EXPECT_EQ(options.engine.opengl.depth_format, DepthFormat::fixed24);
    EXPECT_EQ(options.engine.interleave, 4);
    EXPECT_TRUE(options.engine.no_interpolate);
    EXPECT_EQ(options.shadows, Shadows::none);
    EXPECT_TRUE(options.json);
    EXPECT_NO_THROW(check(options));
}

TEST(CompareOptions, AnOracleArrives)
{
    const CompareOptions options = parse_compare_options("s --against embree --shadows exact");
    EXPECT_EQ(options.oracle, Oracle::embree);
    EXPECT_EQ(options.engine.engine, Engine::cpu);
    EXPECT_NO_THROW(check(options));
}

TEST(CompareOptions, TheCpuEngineIsNotComparedWithItself)
{
    for (const char* engine : {"", " --engine cpu", " --engine auto"})
        EXPECT_THROW(
            check(parse_compare_options(std::string("s --against cpu") + engine)), UsageError)
            << engine;
    EXPECT_EQ(message_of<UsageError>([] { check(parse_compare_options("s --against cpu")); }),
        "--against cpu needs an engine on OpenGL, not cpu: say --engine hybrid or --engine gpu");
}

TEST(CompareOptions, OraclesAreForTheCpuEngine)
{
    EXPECT_EQ(message_of<UsageError>(
                  [] { check(parse_compare_options("s --against brute --engine gpu")); }),
        "--engine gpu is compared with --against cpu");
}

TEST(CompareOptions, ShadowsFitWhatIsCompared)
{
    EXPECT_THROW(check(parse_compare_options("s --against brute --shadows map")), UsageError);
    EXPECT_THROW(
        check(parse_compare_options("s --against cpu --engine gpu --shadows exact")), UsageError);
    EXPECT_NO_THROW(
        check(parse_compare_options("s --against cpu --engine hybrid --shadows exact")));
    EXPECT_NO_THROW(check(parse_compare_options("s --against cpu --engine gpu --shadows map")));
}

TEST(CompareOptions, WrongWordsAreNamed)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_compare_options("s --against guessing"); }),
        "--against: 'guessing' cannot be compared with: accepted are brute, embree and cpu");
    EXPECT_THROW(parse_compare_options("s --against cpu --engine none"), UsageError);
}

} // namespace
} // namespace firsthit::cli
