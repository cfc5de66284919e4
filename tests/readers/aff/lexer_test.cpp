// lexer_test.cpp - tokens, lines and numbers of AFF.
#include "readers/aff/lexer.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firsthit::aff {
namespace {

std::vector<std::string> tokens_of(std::string_view text)
{
    Lexer lexer("f", text);
    std::vector<std::string> tokens;
    while (!lexer.peek().empty()) tokens.emplace_back(lexer.next());
    return tokens;
}

using Tokens = std::vector<std::string>;

TEST(Lexer, SeparatesByAnyWhiteSpace)
{
    EXPECT_EQ(tokens_of(" a\tb\r\nc\n\n\vd\f"), (Tokens{"a", "b", "c", "d"}));
}

TEST(Lexer, SkipsBothKindsOfCommentsWhereverTheyStand)
{
    EXPECT_EQ(tokens_of("# one\na % two {\nb#three\nc%"), (Tokens{"a", "b", "c"}));
}

TEST(Lexer, GivesBracesThatTouchTheirNeighbours)
{
    EXPECT_EQ(tokens_of("x name{s 0}}k"), (Tokens{"x", "name", "{", "s", "0", "}", "}", "k"}));
}

TEST(Lexer, FindsNothingInTextWithoutTokens)
{
    EXPECT_TRUE(tokens_of("").empty());
    EXPECT_TRUE(tokens_of(" \r\n# only words").empty());
}

TEST(Lexer, SkipsAByteOrderMark)
{
    EXPECT_EQ(tokens_of("\xEF\xBB\xBF"
                        "a"),
        Tokens{"a"});
}

TEST(Lexer, CountsLinesOfEveryKindOfEnding)
{
    for (const char* text : {"a\n\nb", "a\r\n\r\nb", "a\r\rb", "a % x\n# y\nb"}) {
        Lexer lexer("f", text);
        lexer.next();
        EXPECT_EQ(lexer.line(), 1u);
        lexer.peek(); // looking ahead takes nothing
        EXPECT_EQ(lexer.line(), 1u);
        lexer.next();
        EXPECT_EQ(lexer.line(), 3u);
    }
}

TEST(Lexer, ReadsNumbersAsTheyAreWritten)
{
    Lexer lexer("f", "1 -2.5 +3 .5 5. 1e3 1E-3 -0 1e-400 -1e-400");
    for (const double expected : {1.0, -2.5, 3.0, 0.5, 5.0, 1e3, 1e-3, -0.0, 0.0, 0.0})
        EXPECT_EQ(lexer.number("x"), expected);
}

TEST(Lexer, TakesANumberOnlyIfItIsNext)
{
    Lexer lexer("f", "1 l");
    EXPECT_EQ(lexer.small_number_if_next("x"), 1.0f);
    EXPECT_FALSE(lexer.small_number_if_next("x"));
    EXPECT_EQ(lexer.next(), "l");
    EXPECT_FALSE(lexer.small_number_if_next("x"));
}

TEST(Lexer, RefusesWhatIsNoNumber)
{
    for (const char* text : {"a", "1a", "--1", "+-1", "0x10", "1,5", "{", ""}) {
        Lexer lexer("f", text);
        EXPECT_THROW(lexer.number("x"), FileError) << text;
    }
}

TEST(Lexer, RefusesNumbersThatAreNotFinite)
{
    for (const char* text : {"nan", "inf", "-inf", "infinity", "1e400", "-1e400"}) {
        Lexer lexer("f", text);
        EXPECT_THROW(lexer.number("x"), SceneError) << text;
    }
    Lexer lexer("f", "1e39");
    EXPECT_THROW(lexer.small_number("x"), SceneError);
}

TEST(Lexer, RefusesCountsOutOfRange)
{
    Lexer good("f", "4294967295");
    EXPECT_EQ(good.count("x"), 4294967295u);
    for (const char* text : {"-1", "4294967296", "99999999999999999999", "1.5", "a", ""}) {
        Lexer lexer("f", text);
        EXPECT_THROW(lexer.count("x"), FileError) << text;
    }
}

TEST(Lexer, ShowsOddBytesAndLongTokensShort)
{
    EXPECT_EQ(in_quotes("a\xff\n"), "'a\\xff\\x0a'");
    EXPECT_EQ(in_quotes(std::string(100, 'a')), "'" + std::string(40, 'a') + "...'");
}

} // namespace
} // namespace firsthit::aff
