// tables.cpp - the paper's tables 1 to 4, ours beside its.
#include "bench/paper/tables.h"

#include "bench/paper/numbers.h"

#include <fmt/format.h>

namespace firsthit::cli::bench {

namespace {

Cell paper_cell(double paper, const Quartiles* ours)
{
    if (paper == 0) return {""};
    if (!ours) return {fmt::format("{:g}", paper)};
    return {
        fmt::format("{:g}", paper), fmt::format("ours is {}x", number_text(ours->median / paper))};
}

/// Table 1.
void add_scenes(const PaperMeasured& measured, Report& report, Json& json)
{
    Table table{.title = "Table 1: the scenes",
        .head = {"scene", "triangles", "paper", "vertices", "frames", "file"},
        .rows = {},
        .note = {}};
    Json rows = Json::array();
    for (std::size_t k = 0; k < measured.scenes.size(); ++k) {
        const PaperScene& scene = measured.scenes[k];
        const std::string paper = fmt::format("{}", kPaperTriangles[k]);
        Json row = {{"scene", kPaperNames[k]}, {"file", scene.file}, {"note", scene.note},
            {"paper_triangles", kPaperTriangles[k]}};
        if (!scene.scene) {
            row["unavailable"] = scene.note;
            table.rows.push_back({{kPaperNames[k]}, missing_cell(""), {paper}, {"-"}, {"-"},
                {scene.file, scene.note}});
        } else {
            row["triangles"] = scene.scene->triangle_count();
            row["vertices"] = scene.scene->vertex_count();
            table.rows.push_back(
                {{kPaperNames[k]}, {fmt::format("{}", scene.scene->triangle_count())}, {paper},
                    {fmt::format("{}", scene.scene->vertex_count())},
                    {scene.scene->end_s() > scene.scene->begin_s() ? "animated" : "still"},
                    {scene.file, scene.note}});
        }
        rows.push_back(std::move(row));
    }
    report.add(table);
    json["table1"] = std::move(rows);
}

/// A number of ours, and what to say of it.
struct Ours {
    std::optional<Quartiles> value;
    std::string reason; // why there is none
};

Ours ours_of(const PaperMeasured& measured, std::size_t scene, const PaperRow& row)
{
    const Frames* const frames = measured.find(scene, row.way);
    if (!frames) return {std::nullopt, measured.scenes[scene].note};
    if (!frames->failure.empty()) return {std::nullopt, frames->failure};
    return {per_second(quartiles(row.items_only ? item_buffer_ms(*frames) : frames->ms)), {}};
}

void add_table(const PaperMeasured& measured, const PaperTable& asked, Report& report, Json& json)
{
    Table table{
        .title = asked.title, .head = {"paper's row: our engine"}, .rows = {}, .note = asked.note};
    for (const char* const name : kPaperNames) {
        table.head.push_back(name);
        table.head.push_back("paper");
    }
    Json rows = Json::array();
    for (const PaperRow& row : asked.rows) {
        std::vector<Cell> cells = {{row.name}};
        Json numbers = Json::array();
        for (std::size_t k = 0; k < kPaperScenes; ++k) {
            const Ours ours = ours_of(measured, k, row);
            Json number = {{"scene", kPaperNames[k]}};
            if (ours.value)
                number["fps"] = quartiles_json(*ours.value);
            else
                number["unavailable"] = ours.reason;
            if (row.paper[k] != 0) number["paper_fps"] = row.paper[k];
            numbers.push_back(std::move(number));
            cells.push_back(ours.value ? cell(*ours.value) : missing_cell(ours.reason));
            cells.push_back(paper_cell(row.paper[k], ours.value ? &*ours.value : nullptr));
        }
        rows.push_back({{"row", row.name}, {"way", row.way}, {"items_only", row.items_only},
            {"scenes", std::move(numbers)}});
        table.rows.push_back(std::move(cells));
    }
    report.add(table);
    json[fmt::format("table{}", asked.number)] = std::move(rows);
}

/// Of frames of the same rounds, so that what disturbs the machine disturbs both.
Ours ratio_of(const PaperMeasured& measured, std::size_t scene, const PaperRatio& asked)
{
    const Frames* const ours = measured.find(scene, asked.way);
    const Frames* const slower = measured.find(scene, asked.slower);
    if (!ours || !slower) return {std::nullopt, measured.scenes[scene].note};
    for (const Frames* const frames : {ours, slower})
        if (!frames->failure.empty()) return {std::nullopt, frames->failure};
    std::vector<double> ratios;
    for (std::size_t k = 0; k < ours->ms.size(); ++k) ratios.push_back(slower->ms[k] / ours->ms[k]);
    return {quartiles(std::move(ratios)), {}};
}

void add_ratios(const PaperMeasured& measured, Report& report, Json& json)
{
    Table table{.title = "The cpu engine beside the engines on OpenGL: times as fast",
        .head = {"frames"},
        .rows = {},
        .note = "No multisampling; medians of frames of the same round. Not in the paper."};
    table.head.insert(table.head.end(), kPaperNames.begin(), kPaperNames.end());
    Json rows = Json::array();
    for (const PaperRatio& asked : kRatios) {
        std::vector<Cell> cells = {{asked.name}};
        Json numbers = Json::array();
        for (std::size_t k = 0; k < kPaperScenes; ++k) {
            const Ours ratio = ratio_of(measured, k, asked);
            cells.push_back(ratio.value ? cell(*ratio.value) : missing_cell(ratio.reason));
            Json number = {{"scene", kPaperNames[k]}};
            if (ratio.value)
                number["times"] = quartiles_json(*ratio.value);
            else
                number["unavailable"] = ratio.reason;
            numbers.push_back(std::move(number));
        }
        rows.push_back({{"row", asked.name}, {"way", asked.way}, {"slower", asked.slower},
            {"scenes", std::move(numbers)}});
        table.rows.push_back(std::move(cells));
    }
    report.add(table);
    json["ratios"] = std::move(rows);
}

} // namespace

const Frames* PaperMeasured::find(std::size_t scene, const std::string& way) const
{
    for (std::size_t k = 0; k < frames[scene].size(); ++k)
        if (ways[k].name == way) return &frames[scene][k];
    return nullptr;
}

void add_paper_tables(const PaperMeasured& measured, Report& report, Json& json)
{
    add_scenes(measured, report, json);
    for (const PaperTable& table : kTables) add_table(measured, table, report, json);
    add_ratios(measured, report, json);
}

} // namespace firsthit::cli::bench
