// page_test.cpp - texts, tables and pictures of the page.
#include "bench/densest_window.h"
#include "bench/markup.h"
#include "bench/page.h"
#include "bench/report.h"
#include "bench/well_formed.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace firsthit::cli::bench {
namespace {

const std::string kNasty = "<script>\"a\" & 'b'</script>";

std::span<const std::uint8_t> bytes(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Markup, NamesStayNames)
{
    EXPECT_EQ(escaped("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(Markup, WhatIsNoTextIsReplaced)
{
    EXPECT_EQ(escaped("a\x01z"), "a\xEF\xBF\xBDz");
    EXPECT_EQ(escaped("a\xFFz"), "a\xEF\xBF\xBDz");               // no UTF-8
    EXPECT_EQ(escaped("a\xC3"), "a\xEF\xBF\xBD");                 // ends too soon
    EXPECT_EQ(escaped("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");   // longer than needed
    EXPECT_EQ(escaped("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\x87 z"), // é, euro, a rabbit
        "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\x87 z");
}

TEST(Markup, Base64IsThatOfRfc4648)
{
    EXPECT_EQ(base64(bytes("")), "");
    EXPECT_EQ(base64(bytes("f")), "Zg==");
    EXPECT_EQ(base64(bytes("fo")), "Zm8=");
    EXPECT_EQ(base64(bytes("foo")), "Zm9v");
    EXPECT_EQ(base64(bytes("foobar")), "Zm9vYmFy");
    EXPECT_EQ(base64(bytes("\xFB\xEF\xFF")), "++//");
}

TEST(Table, NumbersHaveThreeDigitsThatCount)
{
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.01234), "0.0123");
    EXPECT_EQ(number_text(4.5), "4.50");
    EXPECT_EQ(number_text(78.94), "78.9");
    EXPECT_EQ(number_text(123456), "123456");
    EXPECT_EQ(number_text(1.0 / 0.0), "-");
    EXPECT_EQ(number_text(std::nan("")), "-");
}

Table nasty_table()
{
    return {.title = kNasty,
        .head = {"name", kNasty},
        .rows = {{{kNasty}, {"1", kNasty}}, {{"two"}, {"22"}}},
        .note = kNasty};
}

TEST(Table, AsHtmlIsWellFormedWhateverTheNames)
{
    const std::string html = table_html(nasty_table());
    EXPECT_EQ(xml_error(html), "");
    EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(Table, AsTextHasColumns)
{
    const Table table{.title = "Speeds",
        .head = {"who", "fps"},
        .rows = {{{"cpu"}, {"7"}}, {{"h\xC3\xA9"}, {"31.2", "30 to 32"}}},
        .note = {}};
    EXPECT_EQ(table_text(table), "Speeds\n"
                                 "who              fps\n"
                                 "cpu                7\n"
                                 "h\xC3\xA9   31.2 (30 to 32)\n");
}

TEST(Table, WhatIsMissingSaysWhy)
{
    const Table table{
        .title = "", .head = {"a", "b"}, .rows = {{{"x"}, missing_cell("no OpenGL")}}, .note = {}};
    EXPECT_NE(table_html(table).find("-<small>no OpenGL</small>"), std::string::npos);
}

TEST(Report, IsWrittenIntoAFolderThatIsMade)
{
    const TemporaryFolder folder;
    Report report;
    report.json["paper"] = 7;
    {
        const ReportFolder made(folder / "new/deep");
        write_report(report, made.path());
    }
    EXPECT_EQ(bytes_of(folder / "new/deep/bench.json"), "{\n  \"paper\": 7\n}\n");
    EXPECT_EQ(bytes_of(folder / "new/deep/index.html"), report.page.html());
}

TEST(Report, AFolderThatCannotBeMadeIsNamed)
{
    const TemporaryFolder folder;
    folder.write("file", "x");
    EXPECT_THROW(ReportFolder(folder / "file/below"), FileError);
    EXPECT_THROW(write_report(Report(), folder / "nowhere"), FileError);
}

TEST(Report, AFolderWithoutAReportGoesAgainUnlessItWasThereBefore)
{
    const TemporaryFolder folder;
    folder.write("old/file", "x");
    for (const char* name : {"new", "new/deep/", "old", "old/new", "old/../new"}) {
        {
            const ReportFolder made(folder / name);
            EXPECT_TRUE(std::filesystem::is_directory(made.path())) << name;
        }
        EXPECT_FALSE(std::filesystem::exists(folder / "new")) << name;
        EXPECT_FALSE(std::filesystem::exists(folder / "old/new")) << name;
        EXPECT_TRUE(std::filesystem::exists(folder / "old/file")) << name;
    }
    std::filesystem::create_directory(folder / "empty");
    {
        const ReportFolder made(folder / "empty");
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "empty"));
}

Picture two_by_one()
{
    return {.width = 2, .height = 1, .rgb = {255, 0, 0, 0, 0, 255}};
}

TEST(Page, IsWellFormedAndNeedsNothingElse)
{
    Page page(kNasty);
    page.heading(kNasty);
    page.subheading("b");
    page.paragraph(kNasty);
    page.add(nasty_table());
    page.add_pictures({{two_by_one(), kNasty}}, kNasty);
    const std::string html = page.html();
    EXPECT_EQ(xml_error(html), "");
    for (const char* const word : {"<script", "<link", "http", "url(", "@import", "<iframe"})
        EXPECT_EQ(html.find(word), std::string::npos) << word;
    EXPECT_NE(html.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
}

TEST(Picture, ColoursAreEncodedAsSrgb)
{
    Film film;
    film.width = 2;
    film.height = 1;
    film.color = {.channels = 3, .value = {0, 0.5f, 1, -1, 2, 0.001f}};
    EXPECT_EQ(picture_of(film).rgb, (std::vector<std::uint8_t>{0, 188, 255, 0, 255, 3}));
}

TEST(Picture, ItemsHaveColoursOfTheirOwnAndNoneIsBlack)
{
    Film film;
    film.width = 3;
    film.height = 1;
    film.item = {0, 1, kNoItem};
    const std::vector<std::uint8_t> rgb = picture_of_items(film).rgb;
    EXPECT_NE(
        std::vector(rgb.begin(), rgb.begin() + 3), std::vector(rgb.begin() + 3, rgb.begin() + 6));
    for (std::size_t k = 0; k < 6; ++k) EXPECT_GE(rgb[k], 64);
    for (std::size_t k = 6; k < 9; ++k) EXPECT_EQ(rgb[k], 0);
}

TEST(Picture, OfAPlaneThatTheFilmLacksIsRefused)
{
    Film film;
    film.width = film.height = 2;
    EXPECT_THROW(picture_of(film), ArgumentError);
    EXPECT_THROW(picture_of_items(film), ArgumentError);
}

TEST(Picture, EnlargingRepeatsPixels)
{
    const Picture large = enlarged(two_by_one(), {.x = 1, .y = 0, .width = 1, .height = 1}, 2);
    EXPECT_EQ(large.width, 2);
    EXPECT_EQ(large.height, 2);
    EXPECT_EQ(large.rgb, (std::vector<std::uint8_t>{0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 255}));
}

TEST(Picture, APartThatReachesOutIsCut)
{
    const Picture part = enlarged(two_by_one(), {.x = 1, .y = -3, .width = 9, .height = 9}, 1);
    EXPECT_EQ(part.width, 1);
    EXPECT_EQ(part.height, 1);
}

TEST(Picture, ThePngSaysItsSize)
{
    const std::vector<std::uint8_t> file = png(two_by_one());
    const std::string begin(file.begin(), file.begin() + 24);
    EXPECT_EQ(begin, std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\x02\0\0\0\x01", 24));
}

TEST(DensestWindow, IsWhereMostMarksAre)
{
    std::vector<std::uint8_t> marks(8 * 6);
    marks[8 * 4 + 5] = marks[8 * 5 + 6] = 1; // two close together
    marks[0] = 1;
    const Region window = densest_window(marks, 8, 2);
    EXPECT_EQ(window.x, 5);
    EXPECT_EQ(window.y, 4);
    EXPECT_EQ(window.width, 2);
    EXPECT_EQ(window.height, 2);
}

TEST(DensestWindow, OfASmallPictureIsAllThatFits)
{
    const std::vector<std::uint8_t> marks(3 * 2);
    const Region window = densest_window(marks, 3, 100);
    EXPECT_EQ(window.width, 2);
    EXPECT_EQ(window.height, 2);
}

} // namespace
} // namespace firsthit::cli::bench
