// picture_options_test.cpp - backgrounds and formats of the command line.
#include "options/picture_options.h"
#include "inputs/standard_input.h"
#include "common/usage.h"

#include "message_of.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

PictureChoices choices(const std::string& line)
{
    PictureChoices options;
    CLI::App app("test", "render");
    add_picture_options(app, options);
    app.parse(line);
    return options;
}

TEST(PictureOptions, ABackgroundIsNothingAColourOrTwo)
{
    EXPECT_TRUE(parse_backdrop("transparent").transparent);
    EXPECT_EQ(parse_backdrop("0,0.5,1").color, glm::vec3(0, 0.5, 1));
    const Backdrop two = parse_backdrop("0,0.5,1:1,0,2");
    ASSERT_TRUE(two.gradient);
    EXPECT_EQ(two.gradient->top, glm::vec3(0, 0.5, 1));
    EXPECT_EQ(two.gradient->bottom, glm::vec3(1, 0, 2));
    EXPECT_TRUE(two.needs_alpha());
    EXPECT_FALSE(parse_backdrop("0,0,0").needs_alpha());
    for (const char* text : {"", "red", "0,0", "0,0,0,0", "-1,0,0", "nan,0,0", "inf,0,0",
             "0,0,0:", ":0,0,0", "0,0,0:0,0,0:0,0,0", "Transparent", "1e7,0,0"})
        EXPECT_NE(
            message_of<UsageError>([&] { parse_backdrop(text); }).find("accepted are transparent"),
            std::string::npos)
            << text;
}

TEST(PictureOptions, TheScenesBackgroundGoes)
{
    Scene scene;
    scene.background = glm::vec3(1);
    scene.environment.background = true;
    apply(Backdrop{}, scene);
    EXPECT_EQ(scene.background, glm::vec3(1));
    apply(parse_backdrop("transparent"), scene);
    EXPECT_EQ(scene.background, glm::vec3(0));
    EXPECT_FALSE(scene.environment.background);
    apply(parse_backdrop("0.25,0.5,1"), scene);
    EXPECT_EQ(scene.background, glm::vec3(0.25, 0.5, 1));
}

TEST(PictureOptions, StandardOutputHasAFormatOfItsOwn)
{
    const PictureChoices plain = choices("--dither off"), chosen = choices("--output-format webp");
    EXPECT_FALSE(picture_options(plain, {}, "-").dither);
    EXPECT_EQ(picture_options(plain, {}, "-").format, ".png");
    EXPECT_EQ(picture_options(chosen, {}, "-").format, ".webp");
    EXPECT_EQ(picture_options(chosen, {}, "a.png").format, "");
    EXPECT_EQ(plane_format(plain, "-"), ".npy");
    EXPECT_EQ(plane_format(plain, "a.exr"), "");
}

TEST(PictureOptions, WhatDoesNotFitIsRefused)
{
    EXPECT_NE(message_of<UsageError>([] {
        check_picture(choices("--background transparent"), "a.jpg");
    }).find("a.jpg: "),
        std::string::npos);
    EXPECT_EQ(message_of<UsageError>([] { check_picture(choices("--quality 50"), "a.png"); }),
        "a.png: --quality is of .jpg and .webp");
    EXPECT_THROW(check_picture(choices("--output-format npy"), "-"), UsageError);
    EXPECT_THROW(check_picture({}, "none/a.png"), FileError);
    for (const char* line : {"--quality 0", "--quality 101", "--quality x", "--dither maybe",
             "--output-format bmp", "--output-format .png"})
        EXPECT_THROW(choices(line), UsageError) << line;
}

TEST(StandardInput, FormatsHaveNames)
{
    EXPECT_EQ(parse_scene_format("glb"), ".glb");
    EXPECT_EQ(message_of<UsageError>([] { parse_scene_format(".stl"); }),
        "'.stl' is no format of scenes: accepted are gltf, glb, fbx, dae, 3mf, aff, nff, ply, stl, "
        "obj, "
        "off");
}

} // namespace
} // namespace firsthit::cli
