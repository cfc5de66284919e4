// page.h - a page of results that needs nothing beside itself: no script, font, style or picture.
#pragma once

#include "bench/picture.h"
#include "bench/table.h"

#include <string>
#include <string_view>

namespace firsthit::cli::bench {

/// Collects the parts of the page in their order. All texts are escaped.
class Page {
  public:
    explicit Page(std::string title) : title_(std::move(title)) {}

    void heading(std::string_view text);    // of a chapter
    void subheading(std::string_view text); // below it
    void paragraph(std::string_view text);
    void add(const Table& table);
    /// svg  of line_plot_svg or stacked_bars_svg (plot.h), taken as it is
    void add_plot(std::string_view svg, std::string_view caption);
    /// The pictures stand side by side where there is room.
    struct Shown {
        Picture picture;
        std::string caption;
    };
    void add_pictures(const std::vector<Shown>& pictures, std::string_view caption);

    /// The whole document.
    std::string html() const;

  private:
    std::string title_;
    std::string body_;
};

} // namespace firsthit::cli::bench
