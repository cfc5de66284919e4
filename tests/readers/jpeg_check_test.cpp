// jpeg_check_test.cpp - Huffman tables that promise too many codes are refused.
#include "readers/image/image_file.h"
#include "readers/image/jpeg_check.h"

#include "message_of.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

namespace firsthit {
namespace {

/// A JPEG that starts with one Huffman table of `codes` codes, at most 255 of each length.
std::string jpeg_with_table(int codes)
{
    std::string bytes = "\xFF\xD8\xFF\xC4";
    const int length = 2 + 17 + codes;
    bytes += static_cast<char>(length >> 8);
    bytes += static_cast<char>(length & 255);
    bytes += '\0';
    for (int left = codes, k = 0; k < 16; ++k) {
        const int here = left < 255 ? left : 255;
        bytes += static_cast<char>(here);
        left -= here;
    }
    return bytes + std::string(static_cast<std::size_t>(codes), '\1');
}

TEST(JpegCheck, ATableMayHave256Codes)
{
    EXPECT_NO_THROW(check_jpeg_tables("a.jpg", jpeg_with_table(256)));
}

TEST(JpegCheck, ATableOf257CodesIsRefusedWithItsPlace)
{
    EXPECT_EQ(message_of<FileError>([] { decode_texture("a.jpg", jpeg_with_table(257)); }),
        "a.jpg: the JPEG picture has a Huffman table of 257 codes at byte 6; accepted are at most "
        "256");
}

TEST(JpegCheck, ASecondTableIsLookedAtToo)
{
    std::string bytes = jpeg_with_table(2);
    bytes[5] = static_cast<char>(bytes[5] + 17 + 1);
    bytes += '\0' + std::string(16, '\x20');
    EXPECT_THROW(check_jpeg_tables("a.jpg", bytes), FileError);
}

TEST(JpegCheck, ATableThatIsCutOffIsLeftToTheDecoder)
{
    const std::string bytes = jpeg_with_table(200);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NO_THROW(check_jpeg_tables("a.jpg", std::span(bytes).first(size)));
}

} // namespace
} // namespace firsthit
