// utf8_test.cpp - text of two bytes a letter becomes UTF-8.
#include "readers/assimp/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace firsthit {
namespace {

std::string utf16(const std::u16string& text)
{
    std::string bytes = "\xFF\xFE";
    for (const char16_t c : text) bytes += {char(c & 255), char(c >> 8)};
    return bytes;
}

TEST(Utf8, IsMadeOfBothByteOrders)
{
    EXPECT_EQ(as_utf8(utf16(u"aé€😀")), "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
    EXPECT_EQ(as_utf8(std::string("\xFE\xFF\0a\0b", 6)), "ab");
}

TEST(Utf8, OtherTextStaysAsItIs)
{
    for (const char* text : {"", "a", "\xEF\xBB\xBF<a/>", "\xFF", "\xC3\xA9"})
        EXPECT_EQ(as_utf8(text), text);
}

TEST(Utf8, HalvesOfPairsAndOddBytesAreHarmless)
{
    const std::string unknown = "\xEF\xBF\xBD";
    EXPECT_EQ(as_utf8(std::string("\xFF\xFE\x00\xD8", 4)), unknown);
    EXPECT_EQ(as_utf8(std::string("\xFF\xFE\x00\xDC\x61\x00\x62", 7)), unknown + "a");
    EXPECT_EQ(as_utf8("\xFF\xFE"), "");
}

} // namespace
} // namespace firsthit
