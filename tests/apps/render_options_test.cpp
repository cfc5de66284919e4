// render_options_test.cpp - the command line of `render`, before any scene is loaded.
#include "options/render_options.h"
#include "common/usage.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <unistd.h>

namespace firsthit::cli {
namespace {

RenderOptions parse_render_options(const std::string& line)
{
    RenderOptions options;
    CLI::App app("test", "render");
    add_render_options(app, options);
    app.parse(line);
    return options;
}

TEST(RenderOptions, EveryOptionArrives)
{
    const RenderOptions options =
        parse_render_options("s.aff -o a.png --time 2.5 --size 64x48 --threads 3 "
                             "--samples 4 --eye -1,2,3 --at 0,0,0 --up 0,0,1 --fov 60 "
                             "--tile-size 32 --stats --stats-json - --crease-angle 90 "
                             "--sphere-segments 16 --cone-segments 8");
    EXPECT_EQ(options.scene.name, "s.aff");
    EXPECT_EQ(options.output, "a.png");
    EXPECT_EQ(options.frames.time_s, 2.5);
    EXPECT_EQ(options.camera.pixels().height, 48);
    EXPECT_EQ(options.threads, 3);
    EXPECT_EQ(options.samples, 4);
    EXPECT_EQ(options.camera.eye, glm::dvec3(-1, 2, 3));
    EXPECT_EQ(options.camera.up, glm::dvec3(0, 0, 1));
    EXPECT_TRUE(options.camera.fov_y_rad.has_value());
    EXPECT_EQ(options.tile_size, 32);
    EXPECT_TRUE(options.stats);
    EXPECT_EQ(options.stats_json, "-");
    EXPECT_NEAR(options.scene.load.crease_angle_rad, 1.5707963, 1e-6);
    EXPECT_EQ(options.scene.load.sphere_segments, 16);
    EXPECT_EQ(options.scene.load.cone_segments, 8);
}

TEST(RenderOptions, TakesAllSegmentsThatScenesTake)
{
    for (const int n : {LoadSettings::kMinSegments, LoadSettings::kMaxSegments})
        for (const char* option : {"--sphere-segments ", "--cone-segments "})
            EXPECT_NO_THROW(parse_render_options("s -o a.png " + (option + std::to_string(n))));
}

TEST(RenderOptions, WhatIsInterpolatedArrives)
{
    const Settings plain = render_settings(parse_render_options("s -o a.png"));
    EXPECT_EQ(plain.interleave, 1);
    EXPECT_EQ(plain.multisample, Multisample::lazy3);
    EXPECT_TRUE(plain.interpolate);
    const Settings settings = render_settings(
        parse_render_options("s -o a.png --interleave 8 --multisample full5 --no-interpolate"));
    EXPECT_EQ(settings.interleave, 8);
    EXPECT_EQ(settings.multisample, Multisample::full5);
    EXPECT_FALSE(settings.interpolate);
}

TEST(RenderOptions, LessAndMoreThanARayAPixelExcludeEachOther)
{
    EXPECT_THROW(check(parse_render_options("s -o a.png --interleave 2 --samples 2")), UsageError);
    EXPECT_NO_THROW(check(parse_render_options("s -o a.png --interleave 2 --samples 1")));
}

TEST(RenderOptions, PicturesHaveMoreRaysAtEdgesUnlessOthersAreAskedFor)
{
    const auto adaptive = [](const std::string& line) {
        const RenderOptions options = parse_render_options(line);
        const Settings settings = render_settings(options);
        EXPECT_TRUE(settings.adaptive == 1 || settings.samples == 1) << line;
        return settings.adaptive;
    };
    EXPECT_EQ(adaptive("s -o a.png"), 4);
    EXPECT_EQ(adaptive("s -o a.png --aov item=i.npy --engine hybrid"), 4);
    EXPECT_EQ(adaptive("s -o a.png --aa 1"), 1);
    EXPECT_EQ(adaptive("s --stats --aa 7"), 7);
    for (const char* line :
        {"s --stats", "s --aov item=i.npy", "s -o a.png --samples 1", "s -o a.png --samples 3",
            "s -o a.png --interleave 2", "s -o a.png --engine gpu --shadows map"})
        EXPECT_EQ(adaptive(line), 1) << line;
    for (const char* line : {"s -o a.png --aa 2 --samples 2", "s -o a.png --aa 2 --interleave 2",
             "s -o a.png --aa 2 --engine gpu --shadows map"})
        EXPECT_THROW(check(parse_render_options(line)), UsageError) << line;
    EXPECT_NO_THROW(check(parse_render_options("s -o a.png --aa 1 --interleave 2")));
    EXPECT_EQ(message_of<UsageError>([] { parse_render_options("s -o a.png --aa 0"); }),
        "--aa: '0' is no integer from 1 to 16");
}

TEST(RenderOptions, PlanesAreCollectedAndLeaveTheSceneAlone)
{
    const RenderOptions options = parse_render_options("--aov item=i.npy --aov depth=d.exr s.ply");
    EXPECT_EQ(options.scene.name, "s.ply");
    ASSERT_EQ(options.aovs.size(), 2u);
    EXPECT_EQ(options.aovs[1].path, "d.exr");
    EXPECT_FALSE(render_settings(options).color);
}

TEST(RenderOptions, WrongValuesAreNamedByTheirOption)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_render_options("s -o a.png --samples 17"); }),
        "--samples: '17' is no integer from 1 to 16");
    EXPECT_EQ(
        message_of<UsageError>([] { parse_render_options("s -o a.png --multisample lazy7"); }),
        "--multisample: 'lazy7' is not accepted: none, lazy3, lazy5, full3, full5 or exact");
    for (const char* line : {"s -o a.png --size 0x0", "s -o a.png --interleave 0",
             "s -o a.png --interleave 3", "s -o a.png --threads -1", "s -o a.png --tile-size 12",
             "s -o a.png --fov 180", "s -o a.png --aov depth", "s -o a.png --crease-angle 181",
             "s -o a.png --sphere-segments 2", "s -o a.png --cone-segments 4097"})
        EXPECT_THROW(parse_render_options(line), UsageError) << line;
}

TEST(RenderOptions, WhatIsNoOptionIsRefused)
{
    for (const char* line : {"", "s -o", "s -o a.png --wrong", "s t -o a.png",
             "s --time 1 --frames 0:1:2", "s --size 1x1 --size 2x2"})
        EXPECT_THROW(parse_render_options(line), CLI::ParseError) << line;
}

TEST(RenderOptions, SomethingMustBeAskedFor)
{
    EXPECT_EQ(message_of<UsageError>([] { check(parse_render_options("s")); }),
        "nothing is asked for: say -o FILE, --aov NAME=FILE or --stats");
    EXPECT_EQ(message_of<UsageError>([] { check(parse_render_options("s --stats")); }), "no error");
}

TEST(RenderOptions, EndingsAreKnownBeforeTheSceneIsLoaded)
{
    EXPECT_EQ(message_of<UsageError>([] {
        check(parse_render_options("s -o a.bmp"));
    }).find("a.bmp: unknown ending '.bmp' for a picture: accepted are .png, "),
        0u);
    EXPECT_EQ(message_of<UsageError>([] { check(parse_render_options("s --aov item=a.png")); }),
        "a.png: the plane 'item' is not written as .png, which is for depth and distance in "
        "millimetres: accepted are .exr and .npy");
    EXPECT_NO_THROW(check(parse_render_options("s --aov depth=a.png")));
}

TEST(RenderOptions, FoldersAreLookedForBeforeTheSceneIsLoaded)
{
    const TemporaryFolder folder;
    EXPECT_THROW(check(parse_render_options("s -o " + (folder / "none/a.png"))), FileError);
    EXPECT_THROW(
        check(parse_render_options("s --stats-json " + (folder / "none/a.json"))), FileError);
    EXPECT_THROW(
        check(parse_render_options("s --frames 0:1:2 -o " + (folder / "none/%d.png"))), FileError);
}

TEST(RenderOptions, FramesNeedNumbersInEveryName)
{
    EXPECT_THROW(check(parse_render_options("s --frames 0:1:2 -o a.png")), UsageError);
    EXPECT_THROW(
        check(parse_render_options("s --frames 0:1:2 -o %d.png --aov item=a.npy")), UsageError);
    const RenderOptions options =
        parse_render_options("s --frames 0:1:2 -o a_%04d.png --aov item=%d.npy");
    check(options);
    EXPECT_EQ(file_name(options, options.output, 1), "a_0001.png");
}

TEST(RenderOptions, NumbersNeedFrames)
{
    EXPECT_EQ(message_of<UsageError>([] { check(parse_render_options("s -o a_%04d.png")); }),
        "'a_%04d.png' numbers frames: say which with --frames or --turntable");
}

TEST(RenderOptions, NoFileIsWrittenTwice)
{
    EXPECT_EQ(
        message_of<UsageError>([] { check(parse_render_options("s -o a.exr --aov depth=a.exr")); }),
        "'a.exr' is to be written twice");
    EXPECT_EQ(message_of<UsageError>(
                  [] { check(parse_render_options("s --aov item=./a.npy --aov depth=a.npy")); }),
        "'a.npy' is to be written twice");
}

TEST(RenderOptions, NoFileIsWrittenTwiceThroughALinkToNothingYet)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("later.exr", folder.path() / "link.exr");
    const std::string link = folder / "link.exr";
    const std::string later = folder / "later.exr";
    EXPECT_EQ(message_of<UsageError>(
                  [&] { check(parse_render_options("s -o " + later + " --aov depth=" + link)); }),
        "'" + link + "' is to be written twice");
}

TEST(RenderOptions, NoOutputReplacesWhatTheSceneWasReadFrom)
{
    Scene scene;
    scene.files = {"s.obj", "f_007.png"};
    const auto message = [&](const std::string& line) {
        return message_of<FileError>([&] { check_inputs_stay(parse_render_options(line), scene); });
    };
    EXPECT_EQ(message("s.obj --stats-json ./s.obj"),
        "./s.obj: cannot write: it would replace the input 's.obj'");
    EXPECT_EQ(message("s.obj -o f_007.png"),
        "f_007.png: cannot write: it would replace the input 'f_007.png'");
    EXPECT_EQ(message("s.obj --frames 0:1:8 -o f_%03d.png"),
        "f_007.png: cannot write: it would replace the input 'f_007.png'");
    EXPECT_EQ(
        message("s.obj --aov uv=s.obj"), "s.obj: cannot write: it would replace the input 's.obj'");
    check_inputs_stay(
        parse_render_options("s.obj --frames 0:1:7 -o f_%03d.png --stats-json -"), scene);
}

TEST(RenderOptions, TheFileSaysHowLargeThePictureIsUnlessTheUserDoes)
{
    Scene scene;
    CameraOptions options;
    take_size(scene, options);
    EXPECT_EQ(options.pixels().width, 1024);
    scene.picture_size = {640, 480};
    take_size(scene, options);
    EXPECT_EQ(options.pixels().width, 640);
    EXPECT_EQ(options.pixels().height, 480);
    options.size = Size{32, 16};
    EXPECT_EQ(options.pixels().width, 32);
    EXPECT_EQ(options.pixels().height, 16);
}

TEST(RenderOptions, AFilmTakesFourBytesAValue)
{
    EXPECT_EQ(
        film_bytes(parse_render_options("s -o a.png --aov normal=n.npy --size 10x10"), 1), 2400u);
    EXPECT_EQ(film_bytes(parse_render_options("s --stats --size 65536x65536"), 1), 51539607552u);
}

TEST(RenderOptions, AFilmIsAsLargeAsItsRegion)
{
    EXPECT_EQ(
        film_bytes(
            parse_render_options("s --aov depth=d.npy --size 60000x60000 --region 5,5,10,20"), 1),
        800u);
    EXPECT_EQ(
        film_bytes(parse_render_options("s -o a.png --background transparent --size 10x10"), 1),
        1600u);
}

TEST(RenderOptions, AFilmHasAValueForEachLight)
{
    EXPECT_EQ(film_bytes(parse_render_options("s --aov lit=l.npy --size 10x10"), 5), 2000u);
    EXPECT_EQ(film_bytes(parse_render_options("s --aov lit=l.npy --size 10x10"), 1000), 25600u)
        << "at most 64";
}

TEST(RenderOptions, LightsAndShadowsArrive)
{
    const RenderOptions options =
        parse_render_options("s -o a.png --light point:1,2,3 --shadows map --shadow-filter 3");
    EXPECT_EQ(options.light.lights.size(), 1u);
    EXPECT_EQ(render_settings(options).shadow_filter, 3);
    EXPECT_THROW(check(parse_render_options("s -o a.png --shadow-filter 3")), UsageError);
}

TEST(RenderOptions, AFilmLargerThanTheMachineIsRefused)
{
    if (sysconf(_SC_PHYS_PAGES) > (40l << 30) / sysconf(_SC_PAGESIZE))
        GTEST_SKIP() << "this machine has the memory";
    EXPECT_THROW(check(parse_render_options("s -o a.png --size 65536x65536")), DeviceError);
}

} // namespace
} // namespace firsthit::cli
