// bench_options_test.cpp - what `firsthit bench` takes, and what it refuses.
#include "bench/bench_options.h"
#include "common/usage.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit::cli::bench {
namespace {

BenchOptions parsed(std::vector<std::string> words)
{
    CLI::App app;
    BenchOptions options;
    add_bench_options(app, options);
    std::reverse(words.begin(), words.end());
    app.parse(words);
    return options;
}

TEST(BenchOptions, AreRead)
{
    const BenchOptions options =
        parsed({"--paper", "--baseline", "-o", "out", "--json", "-", "--bart", "R.aff", "--scenes",
            "models", "--size", "64x32", "--threads", "2", "--rounds", "5"});
    EXPECT_TRUE(options.paper);
    EXPECT_TRUE(options.baseline);
    EXPECT_EQ(output_folder(options), "out");
    EXPECT_EQ(options.json, "-");
    EXPECT_EQ(robots_scene(options), "R.aff");
    EXPECT_EQ(options.scenes, "models");
    EXPECT_EQ(size_of(options).width, 64);
    EXPECT_EQ(size_of(options).height, 32);
    EXPECT_EQ(options.threads, 2);
    EXPECT_EQ(rounds_of(options, 21), 5);
}

TEST(BenchOptions, HaveDefaults)
{
    const BenchOptions options = parsed({"--paper"});
    EXPECT_EQ(output_folder(options), "report");
    EXPECT_EQ(robots_scene(options), "builtin:robots");
    EXPECT_EQ(size_of(options).width, 1024);
    EXPECT_EQ(rounds_of(options, 21), 21);
}

TEST(BenchOptions, QuickIsSmallUnlessToldOtherwise)
{
    EXPECT_EQ(size_of(parsed({"--paper", "--quick"})).width, 128);
    EXPECT_EQ(rounds_of(parsed({"--paper", "--quick"}), 21), 2);
    EXPECT_EQ(size_of(parsed({"--quick", "--size", "32x32"})).width, 32);
    EXPECT_EQ(rounds_of(parsed({"--quick", "--rounds", "3"}), 21), 3);
}

TEST(BenchOptions, WithJsonAloneThereIsNoPage)
{
    EXPECT_EQ(output_folder(parsed({"--paper", "--json", "-"})), "");
}

TEST(BenchOptions, WithoutAModeAreWrongUsage)
{
    EXPECT_THROW(check(parsed({"--quick"})), UsageError);
}

TEST(BenchOptions, OutOfRangeAreWrongUsage)
{
    EXPECT_THROW(parsed({"--rounds", "0"}), UsageError);
    EXPECT_THROW(parsed({"--size", "0x5"}), UsageError);
    EXPECT_THROW(parsed({"--threads", "-1"}), UsageError);
}

TEST(BenchOptions, FramesThatNoMemoryHoldsAreRefusedAtOnce)
{
    EXPECT_THROW(check(parsed({"--paper", "--json", "-", "--size", "65536x65536"})), DeviceError);
}

TEST(BenchOptions, ABartThatIsNotThereIsRefusedAtOnce)
{
    EXPECT_THROW(check(parsed({"--paper", "--json", "-", "--bart", "/no/Robot.aff"})), FileError);
    EXPECT_THROW(check(parsed({"--paper", "--json", "-", "--bart", "/"})), FileError);
}

TEST(BenchOptions, AFolderThatIsAFileIsRefusedAtOnce)
{
    const TemporaryFolder folder;
    const std::string file = folder / "file";
    folder.write("file", "x");
    EXPECT_THROW(check(parsed({"--paper", "-o", file})), FileError);
    EXPECT_THROW(check(parsed({"--paper", "-o", file + "/below"})), FileError);
    EXPECT_THROW(check(parsed({"--paper", "--json", file + "/x.json"})), FileError);
    EXPECT_NO_THROW(check(parsed({"--paper", "-o", folder / "new/deep"})));
}

TEST(BenchOptions, FetchedScenesAreFoundOrNot)
{
    const TemporaryFolder folder;
    folder.write("bunny.stl", "x");
    BenchOptions options;
    options.scenes = folder.path().string();
    EXPECT_EQ(fetched_scene(options, "dragon.ply"), "");
    EXPECT_NE(fetched_scene(options, "bunny.stl"), "");
}

} // namespace
} // namespace firsthit::cli::bench
