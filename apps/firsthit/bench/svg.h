// svg.h - the few elements that plots are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace firsthit::cli::bench {

/// Pixels from the top left.
struct Place {
    double x = 0;
    double y = 0;
};

/// Colours that are told apart on white and on black; taken in turn.
std::string_view series_color(std::size_t series);

/// Collects elements.
class Svg {
  public:
    /// title  what a reader who cannot see it is told
    Svg(double width, double height, std::string_view title);

    enum class Anchor { start, middle, end };

    void text(Place at, std::string_view text, Anchor anchor, std::string_view more = {});
    /// Turned to be read upwards.
    void upright_text(Place at, std::string_view text);
    void line(Place from, Place to, double opacity, std::string_view color = "currentColor");
    void curve(const std::vector<Place>& places, std::string_view color, bool dashed);
    void dot(Place at, std::string_view color);
    void box(Place at, double width, double height, std::string_view color, std::string_view title);

    /// The whole element.
    std::string str() const { return text_ + "</svg>\n"; }

  private:
    std::string text_;
};

} // namespace firsthit::cli::bench
