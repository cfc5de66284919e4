// page_test.cpp - what the page shows, as data; its pictures; the report's folder.
#include "bench/paper/densest_window.h"
#include "bench/report/page.h"
#include "bench/report/report.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace firsthit::cli::bench {
namespace {

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

Picture two_by_one()
{
    return {.width = 2, .height = 1, .rgb = {255, 0, 0, 0, 0, 255}};
}

TEST(Report, IsWrittenIntoAFolderThatIsMade)
{
    const TemporaryFolder folder;
    Report report;
    report.page.add_pictures("figure", {{two_by_one(), "left"}}, "both");
    report.json["page"] = report.page.json();
    {
        const ReportFolder made(folder / "new/deep");
        EXPECT_EQ(write_report(report, made.path()), "");
    }
    EXPECT_EQ(bytes_of(folder / "new/deep/bench.json"), to_text(report.json));
    EXPECT_EQ(bytes_of(folder / "new/deep/figure-1.png").substr(1, 3), "PNG");
    EXPECT_NE(bytes_of(folder / "new/deep/index.html").find("data:image/png;base64,iVBORw0KGgo"),
        std::string::npos);
}

TEST(Report, WithoutAPageComesWithWhatDrawsIt)
{
    // Not what report.py draws: Python says so, as it would say any other failure.
    const TemporaryFolder folder;
    Report report;
    report.json["page"] = 7;
    const std::string warning = write_report(report, folder.path().string());
    for (const std::string& part :
        {folder / "index.html" + " is not written (python3 exits with 1)",
            "run python3 " + folder / "report.py", folder / "bench.json"})
        EXPECT_NE(warning.find(part), std::string::npos) << warning;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"bench.json", "report.py"}));
    EXPECT_NE(bytes_of(folder / "report.py").find("def page_html"), std::string::npos);
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

TEST(Page, IsItsPartsInTheirOrder)
{
    Page page("all");
    page.heading("chapter");
    page.subheading("below");
    page.paragraph("text");
    page.add(Table{.title = "t",
        .head = {"name", "fps"},
        .rows = {{{"cpu"}, {"7", "6 to 8"}}, {{"gpu"}, missing_cell("no OpenGL")}},
        .note = "n"});
    page.add_curves({{"title", "c"}});
    page.add_bars({{"title", "b"}});
    page.add_pictures("figure2", {{two_by_one(), "left"}, {two_by_one(), "right"}}, "both");
    EXPECT_EQ(page.json(), Json::parse(R"({"title": "all", "parts": [
        {"heading": "chapter"}, {"subheading": "below"}, {"paragraph": "text"},
        {"table": {"title": "t", "head": ["name", "fps"],
            "rows": [["cpu", ["7", "6 to 8"]], ["gpu", ["-", "no OpenGL"]]], "note": "n"}},
        {"curves": {"title": "c"}}, {"bars": {"title": "b"}},
        {"pictures": {"caption": "both", "pictures": [
            {"file": "figure2-1.png", "width": 2, "height": 1, "caption": "left"},
            {"file": "figure2-2.png", "width": 2, "height": 1, "caption": "right"}]}}]})"));
    ASSERT_EQ(page.files().size(), 2u);
    EXPECT_EQ(page.files()[1].name, "figure2-2.png");
    EXPECT_EQ(page.files()[1].bytes, png(two_by_one()));
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
