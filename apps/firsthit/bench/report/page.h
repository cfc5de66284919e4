// page.h - what the report's page shows, as data: tools/report.py draws it.
#pragma once

#include "bench/report/picture.h"
#include "bench/report/table.h"
#include "common/json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::cli::bench {

/// Collects the parts of the page in their order. The head of tools/report.py describes each kind.
class Page {
  public:
    explicit Page(std::string title) : title_(std::move(title)) {}

    void heading(std::string_view text) { add("heading", text); } // of a chapter
    void subheading(std::string_view text) { add("subheading", text); }
    void paragraph(std::string_view text) { add("paragraph", text); }
    void add(const Table& table);

    /// {"title", "x": axis, "y": axis, "series", "caption"}; an axis is {"label", "log", "from_zero"}
    void add_curves(Json plot) { add("curves", std::move(plot)); }
    /// {"title", "label", "parts", "bars": [{"name", "values"}], "caption"}
    void add_bars(Json plot) { add("bars", std::move(plot)); }

    /// The pictures stand side by side where there is room.
    /// name  of their files: "name-1.png", ...
    struct Shown {
        Picture picture;
        std::string caption;
    };
    void add_pictures(
        std::string_view name, const std::vector<Shown>& pictures, std::string_view caption);

    /// {"title", "parts"}
    Json json() const { return {{"title", title_}, {"parts", parts_}}; }

    /// The pictures, to be written beside the JSON that names them.
    struct File {
        std::string name;
        std::vector<std::uint8_t> bytes;
    };
    const std::vector<File>& files() const { return files_; }

  private:
    void add(const char* kind, Json content);

    std::string title_;
    Json parts_ = Json::array();
    std::vector<File> files_;
};

} // namespace firsthit::cli::bench
