// parse_test.cpp - words of the command line become values, or errors that quote them.
#include "common/parse.h"
#include "common/usage.h"

#include "message_of.h"

#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

TEST(Parse, ASizeIsTwoSides)
{
    const Size size = parse_size("1920x1080");
    EXPECT_EQ(size.width, 1920);
    EXPECT_EQ(size.height, 1080);
}

TEST(Parse, ASizeGoesFromOneTo65536)
{
    EXPECT_EQ(parse_size("1x65536").height, 65536);
    for (const char* text : {"0x10", "10x0", "-1x10", "65537x1", "100000x100000", "12xx", "x", "",
             "12", "12x", "x12", "1x2x3", "1 x2", "+1x2", "1.5x2", "99999999999x1", "0x10x", "1X2"})
        EXPECT_THROW(parse_size(text), UsageError) << text;
}

TEST(Parse, AWrongSizeIsQuotedWithWhatIsAccepted)
{
    EXPECT_EQ(message_of<UsageError>([] { parse_size("0x10"); }),
        "'0x10' is no size: accepted is WIDTHxHEIGHT, each 1 to 65536, as 1024x768");
}

TEST(Parse, AVectorIsThreeNumbers)
{
    EXPECT_EQ(parse_vector("-1,2.5,3e2"), glm::dvec3(-1, 2.5, 300));
    EXPECT_EQ(parse_vector("-.5,0,0"), glm::dvec3(-0.5, 0, 0));
}

TEST(Parse, AVectorIsNothingElse)
{
    for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,,3", "a,b,c", "1,2,nan", "inf,0,0",
             "1, 2,3", "1;2;3", "1,2,3x"})
        EXPECT_THROW(parse_vector(text), UsageError) << text;
}

TEST(Parse, ANumberIsFinite)
{
    EXPECT_EQ(parse_number("-2.25"), -2.25);
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1,5", "1x", "0x10"})
        EXPECT_THROW(parse_number(text), UsageError) << text;
}

TEST(Parse, AnIntegerStaysInItsRange)
{
    EXPECT_EQ(parse_integer("16", 1, 16), 16);
    for (const char* text : {"0", "17", "-1", "", "4x", "1.0", "99999999999999999999"})
        EXPECT_THROW(parse_integer(text, 1, 16), UsageError) << text;
    EXPECT_EQ(message_of<UsageError>([] { parse_integer("17", 1, 16); }),
        "'17' is no integer from 1 to 16");
}

TEST(Parse, FramesIncludeBothEnds)
{
    EXPECT_EQ(parse_frames("0:10:5"), (std::vector<double>{0, 2.5, 5, 7.5, 10}));
    EXPECT_EQ(parse_frames("0.1:0.7:3").back(), 0.7);
    EXPECT_EQ(parse_frames("5:1:2"), (std::vector<double>{5, 1}));
    EXPECT_EQ(parse_frames("3:9:1"), std::vector<double>{3});
}

TEST(Parse, FramesAreCountedFromOneToAMillion)
{
    EXPECT_EQ(parse_frames("0:1:1000000").size(), 1000000u);
    for (const char* text : {"", "0", "0:1", "0:1:0", "0:1:-3", "0:1:1000001", "0:1:2.5", "a:1:2",
             "0:nan:2", "0:1:2:3", "0:1:", "::"})
        EXPECT_THROW(parse_frames(text), UsageError) << text;
}

TEST(Parse, APlaneHasANameAndAFile)
{
    const AovOutput aov = parse_aov("geometric_normal=a=b.exr");
    EXPECT_EQ(aov.aov, Aov::geometric_normal);
    EXPECT_EQ(aov.path, "a=b.exr");
}

TEST(Parse, AnUnknownPlaneIsAnErrorThatListsTheNames)
{
    EXPECT_THROW(parse_aov("item"), UsageError);
    EXPECT_THROW(parse_aov("item="), UsageError);
    EXPECT_NE(message_of<UsageError>([] { parse_aov("z=z.exr"); }).find("item, depth"),
        std::string::npos);
}

TEST(Parse, MultisamplingHasSixNames)
{
    EXPECT_EQ(parse_multisample("none"), Multisample::none);
    EXPECT_EQ(parse_multisample("lazy5"), Multisample::lazy5);
    EXPECT_EQ(parse_multisample("full3"), Multisample::full3);
    EXPECT_EQ(parse_multisample("exact"), Multisample::exact);
    for (const char* text : {"", "Lazy3", "lazy", "lazy33"})
        EXPECT_THROW(parse_multisample(text), UsageError) << text;
}

TEST(Parse, AFieldOfViewLiesBetweenZeroAnd180Degrees)
{
    EXPECT_NEAR(parse_fov("90"), 1.5707963267948966, 1e-15);
    for (const char* text : {"0", "180", "-45", "nan", "wide", ""})
        EXPECT_THROW(parse_fov(text), UsageError) << text;
}

} // namespace
} // namespace firsthit::cli
