// tables.cpp - what was measured beside Embree, as tables and as JSON.
#include "bench/baseline/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

namespace firsthit::cli::bench {

namespace {

/// "3.2x", with the quartiles beneath.
Cell times_cell(const Quartiles& ratio)
{
    Cell made = cell(ratio);
    if (ratio.count > 0) made.text += "x";
    return made;
}

Cell side_cell(const BaselineRow& row, Side side)
{
    const SideTimes* times = row.find(side);
    if (times) return cell(times->ms);
    return missing_cell(side == Side::embree8 ? row.embree_failure : "");
}

bool has(std::span<const BaselineRow> rows, Side side)
{
    return std::any_of(
        rows.begin(), rows.end(), [&](const BaselineRow& row) { return row.find(side); });
}

std::vector<Side> sides_of(std::span<const BaselineRow> rows)
{
    std::vector<Side> sides;
    for (const Side side : kSides)
        if (side != Side::embree16 || has(rows, side)) sides.push_back(side);
    return sides;
}

void add_times(std::span<const BaselineRow> rows, const std::string& title, Report& report)
{
    const std::vector<Side> sides = sides_of(rows);
    Table table{.title = "Whole frames, milliseconds: " + title,
        .head = {"scene", "triangles"},
        .rows = {},
        .note = "Medians, quartiles beneath. From posing the scene to the picture in memory: pose, "
                "item "
                "buffer and hits or update of the tree and rays, shadows of one light, Phong, "
                "film. Ours is "
                "the cpu engine. Embree's tree is updated in the way that gave it the shortest "
                "frames."};
    for (const Side side : sides) table.head.emplace_back(side_name(side));
    table.head.emplace_back("Embree's update");
    for (const BaselineRow& row : rows) {
        std::vector<Cell> cells{{row.scene}, {fmt::format("{}", row.triangles)}};
        if (!row.unavailable.empty()) {
            cells = {{row.scene}, missing_cell(row.unavailable)};
            cells.resize(table.head.size(), {"-"});
        } else {
            for (const Side side : sides) cells.push_back(side_cell(row, side));
            cells.push_back(
                {row.find(Side::embree8) ? std::string(baseline_update_name(row.update)) : "-"});
        }
        table.rows.push_back(std::move(cells));
    }
    report.add(table);
}

/// Ratios of frames by the clock, or by the processor's time.
void add_ratios(std::span<const BaselineRow> rows, const std::string& title,
    Quartiles (BaselineRow::*ratio)(Side, Side) const, const std::string& note, Report& report)
{
    Table table{.title = title, .head = {"scene"}, .rows = {}, .note = note};
    std::vector<std::pair<Side, Side>> pairs;
    for (const Side embree : {Side::embree8, Side::embree16})
        for (const Side ours : {Side::map, Side::exact})
            if (embree == Side::embree8 || has(rows, embree)) pairs.emplace_back(ours, embree);
    for (const auto& [ours, embree] : pairs)
        table.head.push_back(fmt::format(
            "{}, {} rays", ours == Side::map ? "map" : "exact", embree == Side::embree8 ? 8 : 16));
    for (const BaselineRow& row : rows) {
        std::vector<Cell> cells{{row.scene}};
        for (const auto& [ours, embree] : pairs)
            cells.push_back(times_cell((row.*ratio)(ours, embree)));
        table.rows.push_back(std::move(cells));
    }
    report.add(table);
}

std::string share_text(std::uint64_t count, std::uint64_t pixels)
{
    return pixels == 0 ? ""
                       : fmt::format("{} %", number_text(100.0 * double(count) / double(pixels)));
}

void add_pictures_table(std::span<const BaselineRow> rows, const std::string& title, Report& report)
{
    Table table{.title = "Pixels that are not Embree's: " + title,
        .head = {"scene", "pixels", "exact: item", "exact: colour", "map: item", "map: colour"},
        .rows = {},
        .note =
            "Of one frame. Item: another triangle, or none. Colour: a channel of the 8-bit picture "
            "differs by more than 1. Items differ at ties and where rays meet edges within "
            "Embree's "
            "rounding (firsthit compare --against embree decides each of them exactly); what else "
            "a "
            "map gets wrong are the borders of shadows."};
    for (const BaselineRow& row : rows) {
        if (!row.exact || !row.map) continue;
        std::vector<Cell> cells{{row.scene}, {fmt::format("{}", row.exact->pixels)}};
        for (const PictureDifference* d : {&*row.exact, &*row.map}) {
            cells.push_back({fmt::format("{}", d->items), share_text(d->items, d->pixels)});
            cells.push_back({fmt::format("{}", d->colors), share_text(d->colors, d->pixels)});
        }
        table.rows.push_back(std::move(cells));
    }
    if (!table.rows.empty()) report.add(table);
}

} // namespace

void add_frames_tables(std::span<const BaselineRow> rows, const std::string& title, Report& report)
{
    add_times(rows, title, report);
    add_ratios(rows, "How many times longer Embree takes than ours: " + title, &BaselineRow::ratio,
        "Medians of the ratios of frames that were made one after the other, quartiles beneath.",
        report);
    // The time of several threads is added up: it tells nothing about frames.
    if (std::all_of(
            rows.begin(), rows.end(), [](const BaselineRow& row) { return row.threads == 1; }))
        add_ratios(rows, "The same by the processor's time: " + title, &BaselineRow::cpu_ratio,
            "Of the time in which other programs had the processor, nothing is counted.", report);
    add_pictures_table(rows, title, report);
}

void add_stages_table(std::span<const BaselineRow> rows, Report& report)
{
    Table table{.title = "Where the time goes, milliseconds",
        .head = {"scene: who", "pose", "setup, or update of the tree",
            "raster and resolve, or rays", "shadows", "shading and film", "the rest"},
        .rows = {},
        .note = "Medians by stage; they need not add up to the median frame."};
    for (const BaselineRow& row : rows) {
        for (const SideTimes& times : row.sides) {
            if (times.stages.empty()) continue;
            const auto ms = [&](std::initializer_list<const char*> names) {
                double sum = 0;
                for (const auto& [name, value] : times.stages)
                    if (std::find(names.begin(), names.end(), name) != names.end()) sum += value;
                return sum;
            };
            double all = 0;
            for (const auto& [name, value] : times.stages) all += value;
            table.rows.push_back({{fmt::format("{}: {}", row.scene, side_name(times.side))},
                {number_text(ms({"pose"}))}, {number_text(ms({"setup", "update"}))},
                {number_text(ms({"raster", "resolve", "primary"}))}, {number_text(ms({"shadow"}))},
                {number_text(ms({"shade"}))}, {number_text(std::max(0.0, times.ms.median - all))}});
        }
    }
    report.add(table);
}

void add_asked_table(std::span<const BaselineScene> scenes, std::span<const BaselineRow> rows,
    Report& report, Json& json)
{
    Table table{
        .title = "Asked and measured: times as fast as Embree's packets of 8 rays, 1 thread",
        .head = {"scene", "map: asked", "measured", "by processor's time", "reached",
            "exact: asked", "measured", "by processor's time", "reached"},
        .rows = {},
        .note = "Whether it is reached is said by the clock."};
    Json list = Json::array();
    for (const BaselineScene& scene : scenes) {
        if (scene.asked_map == 0) continue;
        const auto row = std::find_if(
            rows.begin(), rows.end(), [&](const BaselineRow& r) { return r.scene == scene.name; });
        if (row == rows.end()) continue;
        std::vector<Cell> cells{{scene.name}};
        Json entry = {{"scene", scene.name}};
        for (const auto& [ours, asked, name] : {std::tuple(Side::map, scene.asked_map, "map"),
                 std::tuple(Side::exact, scene.asked_exact, "exact")}) {
            const Quartiles ratio = row->ratio(ours, Side::embree8);
            const bool measured = ratio.count > 0, reached = measured && ratio.median >= asked;
            cells.push_back({fmt::format("{:g}x", asked)});
            const Quartiles cpu_ratio = row->cpu_ratio(ours, Side::embree8);
            cells.push_back(times_cell(ratio));
            cells.push_back(times_cell(cpu_ratio));
            cells.push_back({measured ? reached ? "yes" : "no" : "-"});
            entry[name] = {{"asked", asked}};
            if (measured) {
                entry[name]["measured"] = ratio.median;
                entry[name]["measured_cpu"] = cpu_ratio.median;
                entry[name]["reached"] = reached;
            }
        }
        table.rows.push_back(std::move(cells));
        list.push_back(std::move(entry));
    }
    json["asked"] = std::move(list);
    if (!table.rows.empty()) report.add(table);
}

Json row_json(const BaselineRow& row)
{
    Json json = {{"scene", row.scene}, {"triangles", row.triangles}, {"width", row.size.width},
        {"height", row.size.height}, {"threads", row.threads}};
    if (!row.unavailable.empty()) {
        json["unavailable"] = row.unavailable;
        return json;
    }
    if (!row.embree_failure.empty()) json["embree_unavailable"] = row.embree_failure;
    if (row.find(Side::embree8)) json["update"] = std::string(baseline_update_name(row.update));
    Json sides = Json::array();
    for (const SideTimes& times : row.sides) {
        if (times.ms.count == 0) continue;
        Json stages = Json::object();
        for (const auto& [name, ms] : times.stages) stages[name] = ms;
        sides.push_back(
            {{"side", std::string(side_name(times.side))}, {"ms", quartiles_json(times.ms)},
                {"cpu_ms", quartiles_json(times.cpu_ms)}, {"stages_ms", std::move(stages)}});
    }
    json["sides"] = std::move(sides);
    Json ratios = Json::array();
    for (const Side ours : {Side::map, Side::exact})
        for (const Side embree : {Side::embree8, Side::embree16})
            if (const Quartiles ratio = row.ratio(ours, embree); ratio.count > 0)
                ratios.push_back({{"ours", std::string(side_name(ours))},
                    {"baseline", std::string(side_name(embree))}, {"ratio", quartiles_json(ratio)},
                    {"cpu_ratio", quartiles_json(row.cpu_ratio(ours, embree))}});
    json["ratios"] = std::move(ratios);
    if (row.exact && row.map)
        json["pictures"] = {
            {"exact", difference_json(*row.exact)}, {"map", difference_json(*row.map)}};
    return json;
}

} // namespace firsthit::cli::bench
