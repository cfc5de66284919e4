// parse_number_test.cpp - numbers from words.
#include "scene/parse_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace firsthit {
namespace {

TEST(ParseNumber, TakesWhatAFileMayHold)
{
    EXPECT_EQ(parse_number("1.5"), 1.5);
    EXPECT_EQ(parse_number("+1.5e+2"), 150.0);
    EXPECT_EQ(parse_number("-.25"), -0.25);
    EXPECT_EQ(parse_number("7."), 7.0);
    EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(ParseNumber, TakesWholeWordsOnly)
{
    for (const char* word : {"", "+", "-", "1x", "1,5", "0x10", "1e", "++1", "+-1", " 1", "1 "}) {
        EXPECT_FALSE(parse_number(word)) << word;
        EXPECT_FALSE(parse_integer(word)) << word;
    }
}

TEST(ParseNumber, TellsTooSmallFromTooLarge)
{
    const std::string zeros(400, '0');
    for (const std::string& tiny : {std::string("1e-400"), "-1e-400", "0." + zeros + "1",
             "0." + zeros + "1e+5", std::string("1e-99999999999999999999")})
        EXPECT_EQ(parse_number(tiny), 0.0) << tiny;
    for (const std::string& large : {std::string("1e400"), "-1E+400", "1" + zeros,
             "1" + zeros + "e-5", std::string("1e99999999999999999999")})
        EXPECT_TRUE(std::isinf(parse_number(large).value())) << large;
}

TEST(ParseNumber, IntegersAreThoseOf64Bits)
{
    EXPECT_EQ(parse_integer("+12"), 12);
    EXPECT_EQ(parse_integer("-9223372036854775808"), INT64_MIN);
    EXPECT_FALSE(parse_integer("9223372036854775808"));
    EXPECT_FALSE(parse_integer("1.0"));
}

} // namespace
} // namespace firsthit
