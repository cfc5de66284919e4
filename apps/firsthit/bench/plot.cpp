// plot.cpp - curves and stacked bars as SVG, to stand in the page.
#include "bench/plot.h"

#include "bench/svg.h"
#include "bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::bench {

namespace {

// Pixels. The legend stands at the right, where names of 30 letters have room.
constexpr double kWidth = 900, kHeight = 400, kLeft = 75, kRight = 650, kTop = 40, kBottom = 345;
constexpr double kLegend = 670, kLine = 20;
constexpr std::size_t kMostDots = 40; // a curve of more points has none
constexpr double kFaint = 0.18, kStrong = 0.7;

void draw_title(Svg& svg, const std::string& title)
{
    svg.text({kLeft, 22}, title, Svg::Anchor::start, "font-size=\"15\" font-weight=\"600\"");
}

void draw_axes(Svg& svg, const LinePlot& plot, const Scale& x, const Scale& y)
{
    for (const double tick : x.ticks()) {
        const double at = kLeft + x.place(tick) * (kRight - kLeft);
        svg.line({at, kTop}, {at, kBottom}, kFaint);
        svg.text({at, kBottom + 18}, tick_text(tick), Svg::Anchor::middle);
    }
    for (const double tick : y.ticks()) {
        const double at = kBottom - y.place(tick) * (kBottom - kTop);
        svg.line({kLeft, at}, {kRight, at}, kFaint);
        svg.text({kLeft - 8, at + 4}, tick_text(tick), Svg::Anchor::end);
    }
    svg.line({kLeft, kBottom}, {kRight, kBottom}, kStrong);
    svg.line({kLeft, kTop}, {kLeft, kBottom}, kStrong);
    svg.text({(kLeft + kRight) / 2, kBottom + 42}, plot.x.label, Svg::Anchor::middle);
    svg.upright_text({20, (kTop + kBottom) / 2}, plot.y.label);
}

void draw_series(Svg& svg, const Series& series, std::size_t number, const Scale& x, const Scale& y)
{
    const std::string_view color = series_color(number);
    const auto height = [&](double value) {
        return kBottom - std::clamp(y.place(value), 0.0, 1.0) * (kBottom - kTop);
    };
    std::vector<Place> run;
    for (const Point& point : series.points) {
        if (!x.holds(point.x) || !y.holds(point.y)) {
            svg.curve(run, color, series.dashed);
            run.clear();
            continue;
        }
        const Place at{kLeft + x.place(point.x) * (kRight - kLeft), height(point.y)};
        run.push_back(at);
        if (series.points.size() <= kMostDots && !series.dashed) svg.dot(at, color);
        if (point.upper > 0 && y.holds(point.lower) && y.holds(point.upper))
            svg.line({at.x, height(point.lower)}, {at.x, height(point.upper)}, kStrong, color);
    }
    svg.curve(run, color, series.dashed);
    const double row = kTop + 10 + kLine * double(number);
    svg.curve({{kLegend, row}, {kLegend + 24, row}}, color, series.dashed);
    svg.text({kLegend + 32, row + 4}, series.name, Svg::Anchor::start);
}

double finite(double value)
{
    return std::isfinite(value) ? std::max(0.0, value) : 0;
}

} // namespace

std::string line_plot_svg(const LinePlot& plot)
{
    std::vector<double> xs, ys;
    for (const Series& series : plot.series)
        for (const Point& point : series.points) {
            xs.push_back(point.x);
            ys.push_back(point.y);
            if (point.upper > 0) ys.insert(ys.end(), {point.lower, point.upper});
        }
    const Scale x(plot.x, xs), y(plot.y, ys);
    const double legend_end = kTop + 20 + kLine * double(plot.series.size());
    Svg svg(kWidth, std::max(kHeight, legend_end), plot.title);
    draw_title(svg, plot.title);
    draw_axes(svg, plot, x, y);
    for (std::size_t k = 0; k < plot.series.size(); ++k) draw_series(svg, plot.series[k], k, x, y);
    return svg.str();
}

std::string stacked_bars_svg(const StackedBars& plot)
{
    constexpr double kBar = 24, kGap = 14, kBarLeft = 190;
    std::vector<double> sums;
    for (const Bar& bar : plot.bars) {
        sums.push_back(0);
        for (const double value : bar.values) sums.back() += finite(value);
    }
    const Scale scale({.label = plot.label}, sums);
    const double bottom = kTop + kGap + (kBar + kGap) * double(plot.bars.size());
    const double legend_end = kTop + 20 + kLine * double(plot.parts.size());
    Svg svg(kWidth, std::max(bottom + 55, legend_end), plot.title);
    draw_title(svg, plot.title);
    for (const double tick : scale.ticks()) {
        const double at = kBarLeft + scale.place(tick) * (kRight - kBarLeft);
        svg.line({at, kTop}, {at, bottom}, kFaint);
        svg.text({at, bottom + 18}, tick_text(tick), Svg::Anchor::middle);
    }
    for (std::size_t k = 0; k < plot.bars.size(); ++k) {
        const Bar& bar = plot.bars[k];
        const double top = kTop + kGap + (kBar + kGap) * double(k);
        svg.text({kBarLeft - 8, top + kBar / 2 + 4}, bar.name, Svg::Anchor::end);
        double sum = 0;
        for (std::size_t part = 0; part < std::min(bar.values.size(), plot.parts.size()); ++part) {
            const double value = finite(bar.values[part]);
            const double from = kBarLeft + scale.place(sum) * (kRight - kBarLeft);
            sum += value;
            const double to = kBarLeft + scale.place(sum) * (kRight - kBarLeft);
            if (value > 0)
                svg.box({from, top}, to - from, kBar, series_color(part),
                    fmt::format("{}, {}: {}", bar.name, plot.parts[part], number_text(value)));
        }
    }
    svg.line({kBarLeft, kTop}, {kBarLeft, bottom}, kStrong);
    svg.text({(kBarLeft + kRight) / 2, bottom + 42}, plot.label, Svg::Anchor::middle);
    for (std::size_t part = 0; part < plot.parts.size(); ++part) {
        const double row = kTop + 10 + kLine * double(part);
        svg.box({kLegend, row - 6}, 24, 12, series_color(part), plot.parts[part]);
        svg.text({kLegend + 32, row + 4}, plot.parts[part], Svg::Anchor::start);
    }
    return svg.str();
}

} // namespace firsthit::cli::bench
