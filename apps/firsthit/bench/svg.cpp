// svg.cpp - the few elements that plots are made of.
#include "bench/svg.h"

#include "bench/markup.h"

#include <fmt/format.h>

#include <array>

namespace firsthit::cli::bench {

namespace {

constexpr std::array<std::string_view, 8> kColors = {
    "#2f7ed8", "#d9541e", "#2e9e4f", "#b0419f", "#c79a00", "#13a3b5", "#d6336c", "#7d7f88"};

const char* anchor_name(Svg::Anchor anchor)
{
    return anchor == Svg::Anchor::start    ? "start"
           : anchor == Svg::Anchor::middle ? "middle"
                                           : "end";
}

} // namespace

std::string_view series_color(std::size_t series)
{
    return kColors[series % kColors.size()];
}

Svg::Svg(double width, double height, std::string_view title)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" "
                        "width=\"{0:g}\" height=\"{1:g}\" role=\"img\" font-family=\"sans-serif\" "
                        "font-size=\"12\" fill=\"currentColor\">\n<title>{2}</title>\n",
          width, height, escaped(title)))
{
}

void Svg::text(Place at, std::string_view text, Anchor anchor, std::string_view more)
{
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}{}>{}</text>\n", at.x,
        at.y, anchor_name(anchor), more.empty() ? "" : " ", more, escaped(text));
}

void Svg::upright_text(Place at, std::string_view text)
{
    text_ += fmt::format("<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
                         "text-anchor=\"middle\">{}</text>\n",
        at.x, at.y, escaped(text));
}

void Svg::line(Place from, Place to, double opacity, std::string_view color)
{
    text_ +=
        fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
                    "stroke-opacity=\"{:g}\"/>\n",
            from.x, from.y, to.x, to.y, color, opacity);
}

void Svg::curve(const std::vector<Place>& places, std::string_view color, bool dashed)
{
    if (places.size() < 2) return;
    text_ += "<polyline points=\"";
    for (std::size_t k = 0; k < places.size(); ++k)
        text_ += fmt::format("{}{:.1f},{:.1f}", k ? " " : "", places[k].x, places[k].y);
    text_ += fmt::format(
        "\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"{}/>\n", color,
        dashed ? " stroke-dasharray=\"6 4\"" : "");
}

void Svg::dot(Place at, std::string_view color)
{
    text_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", at.x, at.y, color);
}

void Svg::box(Place at, double width, double height, std::string_view color, std::string_view title)
{
    text_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\">"
        "<title>{}</title></rect>\n",
        at.x, at.y, width, height, color, escaped(title));
}

} // namespace firsthit::cli::bench
