// frame_pattern_test.cpp - names of numbered files.
#include "inputs/frame_pattern.h"
#include "common/usage.h"

#include "message_of.h"

#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

TEST(FramePattern, PutsTheNumberInItsPlace)
{
    EXPECT_EQ(FramePattern("out/a_%04d.png").name(7), "out/a_0007.png");
    EXPECT_EQ(FramePattern("a%d.png").name(123), "a123.png");
    EXPECT_EQ(FramePattern("a%3d.png").name(5), "a  5.png");
    EXPECT_EQ(FramePattern("%0d").name(5), "5");
}

TEST(FramePattern, ANumberThatIsWiderIsNotCut)
{
    EXPECT_EQ(FramePattern("%02d").name(12345), "12345");
}

TEST(FramePattern, TwoPercentSignsAreOne)
{
    EXPECT_EQ(FramePattern("100%%_%d.png").name(1), "100%_1.png");
}

TEST(FramePattern, AcceptsNothingElse)
{
    for (const char* text :
        {"", "a.png", "%%", "%", "a%", "%s", "%n", "%x", "%u", "%4", "%04", "%-4d", "%+d", "% d",
            "%ld", "%10d", "%0999999d", "%.3d", "%*d", "%1$d", "%d%d", "%d_%04d", "%d%n"})
        EXPECT_THROW(FramePattern{text}, UsageError) << text;
}

TEST(FramePattern, SaysWhatIsWrong)
{
    EXPECT_EQ(message_of<UsageError>([] { FramePattern("a.png"); }),
        "'a.png' has no %d: the names of numbered files need exactly one place for their number, "
        "as "
        "in frames_%04d");
    EXPECT_EQ(message_of<UsageError>([] { FramePattern("%s"); }),
        "'%s' has a % that is not %d, %4d or %04d: the names of numbered files need exactly one "
        "place for their number, as in frames_%04d");
}

TEST(FramePattern, IsRecognisedWhereItWasForgottenToBeUsed)
{
    EXPECT_TRUE(looks_like_pattern("a_%04d.png"));
    EXPECT_TRUE(looks_like_pattern("%d"));
    EXPECT_FALSE(looks_like_pattern("100%.png"));
}

} // namespace
} // namespace firsthit::cli
