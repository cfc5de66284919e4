// plot_test.cpp - axes, curves and bars.
#include "bench/axis.h"
#include "bench/plot.h"
#include "bench/well_formed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace firsthit::cli::bench {
namespace {

const std::string kNasty = "<b>\"a\" & 'b'</b>";
const double kNan = std::nan("");

std::size_t count(const std::string& text, const std::string& word)
{
    std::size_t times = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++times;
    return times;
}

TEST(Scale, BeginsAtZeroAndEndsAtATick)
{
    const Scale scale({.label = "ms"}, {3, 47});
    EXPECT_EQ(scale.ticks(), (std::vector<double>{0, 10, 20, 30, 40, 50}));
    EXPECT_EQ(scale.place(0), 0);
    EXPECT_EQ(scale.place(50), 1);
    EXPECT_EQ(scale.place(25), 0.5);
}

TEST(Scale, MayBeginWhereTheValuesDo)
{
    const Scale scale({.label = "s", .from_zero = false}, {100, 104});
    EXPECT_EQ(scale.place(100), 0);
    EXPECT_EQ(scale.place(104), 1);
    EXPECT_EQ(scale.ticks(), (std::vector<double>{100, 101, 102, 103, 104}));
}

TEST(Scale, OfLogarithmsHasPowersOfTen)
{
    const Scale scale({.label = "triangles", .log = true}, {1e3, 1e7});
    ASSERT_EQ(scale.ticks().size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(scale.ticks()[k] / std::pow(10, 3 + double(k)), 1, 1e-12);
        EXPECT_NEAR(scale.place(scale.ticks()[k]), double(k) / 4, 1e-12);
    }
}

TEST(Scale, OfFewLogarithmsHasTwosAndFivesToo)
{
    const Scale scale({.label = "fps", .log = true}, {3, 80});
    ASSERT_EQ(scale.ticks().size(), 6u); // 2 5 10 20 50 100
    EXPECT_NEAR(scale.ticks()[0], 2, 1e-12);
    EXPECT_NEAR(scale.ticks()[5], 100, 1e-10);
}

TEST(Scale, LeavesOutWhatItCannotShow)
{
    const Scale log({.label = "", .log = true}, {-1, 0, kNan, 1.0 / 0.0, 10, 20});
    EXPECT_FALSE(log.holds(0));
    EXPECT_FALSE(log.holds(-1));
    EXPECT_FALSE(log.holds(kNan));
    EXPECT_EQ(log.place(10), 0);
    EXPECT_EQ(log.place(20), 1);
}

TEST(Scale, OfNothingOrOfEqualValuesStillHasALength)
{
    for (const bool log : {false, true})
        for (const std::vector<double>& values : {std::vector<double>{}, {0, 0}, {5, 5}, {1, 1}}) {
            const Scale scale({.label = "", .log = log, .from_zero = false}, values);
            EXPECT_FALSE(scale.ticks().empty());
            EXPECT_TRUE(std::isfinite(scale.place(7)));
        }
}

TEST(Scale, TicksAreShort)
{
    EXPECT_EQ(tick_text(0), "0");
    EXPECT_EQ(tick_text(0.5), "0.5");
    EXPECT_EQ(tick_text(2000), "2000");
    EXPECT_EQ(tick_text(20000), "20k");
    EXPECT_EQ(tick_text(1e7), "10M");
    EXPECT_EQ(tick_text(0.1 * 3), "0.3");
}

LinePlot plot_of(std::vector<Point> points)
{
    return {.title = kNasty,
        .x = {.label = kNasty},
        .y = {.label = kNasty},
        .series = {{.name = kNasty, .points = std::move(points), .dashed = false}}};
}

TEST(LinePlot, IsWellFormedWhateverTheNames)
{
    const std::string svg =
        line_plot_svg(plot_of({{.x = 1, .y = 2}, {.x = 2, .y = 3, .lower = 2, .upper = 4}}));
    EXPECT_EQ(xml_error(svg), "");
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(LinePlot, ACurveIsInterruptedWhereItHasNoValue)
{
    // One line of the legend, and one of each part.
    const std::string svg = line_plot_svg(plot_of({{.x = 1, .y = 2}, {.x = 2, .y = 3},
        {.x = 3, .y = kNan}, {.x = 4, .y = 1}, {.x = 5, .y = 2}}));
    EXPECT_EQ(count(svg, "<polyline"), 3u);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(LinePlot, NothingToShowIsStillAPlot)
{
    LinePlot plot = plot_of({});
    EXPECT_EQ(xml_error(line_plot_svg(plot)), "");
    plot.series.clear();
    plot.y.log = true;
    EXPECT_EQ(xml_error(line_plot_svg(plot)), "");
}

TEST(LinePlot, QuartilesAreBars)
{
    const std::string without = line_plot_svg(plot_of({{.x = 1, .y = 4}, {.x = 2, .y = 4}}));
    const std::string with = line_plot_svg(plot_of(
        {{.x = 1, .y = 4, .lower = 3, .upper = 4}, {.x = 2, .y = 4, .lower = 3, .upper = 4}}));
    EXPECT_EQ(count(with, "<line"), count(without, "<line") + 2);
}

TEST(LinePlot, ManySeriesHaveRoomInTheLegend)
{
    LinePlot plot = plot_of({});
    plot.series.assign(40, {.name = "one of many", .points = {}, .dashed = false});
    const std::string svg = line_plot_svg(plot);
    EXPECT_EQ(count(svg, "one of many"), 40u);
    EXPECT_NE(svg.find("viewBox=\"0 0 900 860\""), std::string::npos) << svg.substr(0, 200);
}

TEST(StackedBars, IsWellFormedAndHasABoxForEveryPart)
{
    const StackedBars plot{.title = kNasty,
        .label = "%",
        .parts = {kNasty, "shading"},
        .bars = {{kNasty, {25, 75}}, {"cpu", {100, 0}}, {"odd", {kNan, -3}}}};
    const std::string svg = stacked_bars_svg(plot);
    EXPECT_EQ(xml_error(svg), "");
    EXPECT_EQ(count(svg, "<rect"), 3u + 2u); // and the legend
    EXPECT_EQ(svg.find("width=\"-"), std::string::npos);
}

TEST(StackedBars, NothingToShowIsStillAPlot)
{
    EXPECT_EQ(xml_error(stacked_bars_svg({.title = "", .label = "", .parts = {}, .bars = {}})), "");
}

} // namespace
} // namespace firsthit::cli::bench
