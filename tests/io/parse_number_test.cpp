// parse_number_test.cpp - numbers from words.
#include "io/parse_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

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
    const std::vector<std::string> tiny = {
        "1e-400", "-1e-400", "0." + zeros + "1", "0." + zeros + "1e+5", "1e-99999999999999999999"};
    for (const std::string& word : tiny) EXPECT_EQ(parse_number(word), 0.0) << word;
    const std::vector<std::string> large = {
        "1e400", "-1E+400", "1" + zeros, "1" + zeros + "e-5", "1e99999999999999999999"};
    for (const std::string& word : large)
        EXPECT_TRUE(std::isinf(parse_number(word).value())) << word;
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
