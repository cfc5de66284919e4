// plot.h - curves and stacked bars as SVG, to stand in the page.
#pragma once

#include "bench/axis.h"

#include <string>
#include <vector>

namespace firsthit::cli::bench {

struct Point {
    double x = 0;
    double y = 0;
    double lower = 0; // quartiles of y, drawn as a bar; none where both are 0
    double upper = 0;
};

struct Series {
    std::string name;
    std::vector<Point>
        points;          // in order of x; a point that is not on the axes interrupts the curve
    bool dashed = false; // for what others measured
};

struct LinePlot {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
};

/// One bar, made of as many parts as the plot has.
struct Bar {
    std::string name;
    std::vector<double> values; // at least 0; what is not finite counts as 0
};

struct StackedBars {
    std::string title;
    std::string label; // of the axis, with the unit
    std::vector<std::string> parts;
    std::vector<Bar> bars; // from top to bottom
};

/// An <svg> element that is well-formed XML, with axes, ticks and a legend. Lines and texts have the colour
/// of the text around it.
std::string line_plot_svg(const LinePlot& plot);
std::string stacked_bars_svg(const StackedBars& plot);

} // namespace firsthit::cli::bench
