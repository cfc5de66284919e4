// page.cpp - what the report's page shows, as data: tools/report.py draws it.
#include "bench/report/page.h"

#include <fmt/format.h>

#include <utility>

namespace firsthit::cli::bench {

void Page::add(const char* kind, Json content)
{
    Json part = Json::object();
    part[kind] = std::move(content);
    parts_.push_back(std::move(part));
}

void Page::add(const Table& table)
{
    Json rows = Json::array();
    for (const auto& row : table.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) {
            Json text = cell.text;
            cells.push_back(cell.note.empty() ? text : Json::array({text, cell.note}));
        }
        rows.push_back(std::move(cells));
    }
    add("table", {{"title", table.title}, {"head", table.head}, {"rows", std::move(rows)},
                     {"note", table.note}});
}

void Page::add_pictures(
    std::string_view name, const std::vector<Shown>& pictures, std::string_view caption)
{
    Json list = Json::array();
    for (const auto& [picture, text] : pictures) {
        const std::string file = fmt::format("{}-{}.png", name, list.size() + 1);
        list.push_back({{"file", file}, {"width", picture.width}, {"height", picture.height},
            {"caption", text}});
        files_.push_back({file, png(picture)});
    }
    add("pictures", {{"caption", caption}, {"pictures", std::move(list)}});
}

} // namespace firsthit::cli::bench
