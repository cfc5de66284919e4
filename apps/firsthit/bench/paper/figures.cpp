// figures.cpp - the paper's figures 8 and 9: where the time goes, and how it varies.
#include "bench/paper/figures.h"

#include "bench/paper/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli::bench {

namespace {

const std::vector<std::string> kParts = {
    "scene update", "item buffer", "intersection", "shadows", "shading", "waiting and the rest"};

/// Milliseconds of each part: medians. They need not add up to the median frame, hence the rest is what
/// that leaves.
std::vector<double> parts_of(const Frames& frames)
{
    const auto ms = [&](double Stats::*member) { return median_of(frames, member); };
    std::vector<double> parts = {ms(&Stats::pose_ms), ms(&Stats::setup_ms) + ms(&Stats::raster_ms),
        ms(&Stats::resolve_ms), ms(&Stats::shadow_ms), ms(&Stats::shade_ms)};
    double sum = 0;
    for (const double part : parts) sum += part;
    parts.push_back(std::max(0.0, quartiles(frames.ms).median - sum));
    return parts;
}

/// Of all parts together, per cent.
std::vector<double> shares_of(const std::vector<double>& parts)
{
    double sum = 0;
    for (const double part : parts) sum += part;
    std::vector<double> shares;
    for (const double part : parts) shares.push_back(sum > 0 ? 100 * part / sum : 0);
    return shares;
}

/// The item buffer's share of the paper's frame, by its table 2.
double paper_item_share()
{
    constexpr std::size_t kRobots = 0;
    return 100 * kTable2[1].paper[kRobots] / kTable2[2].paper[kRobots];
}

} // namespace

void add_time_shares(const PaperMeasured& measured, Report& report, Json& json)
{
    constexpr std::size_t kRobots = 0;
    Json shown = Json::array(), bars = Json::array();
    for (const char* const name :
        {"hybrid", "hybrid maps", "cpu", "cpu maps", "cpu exact", "gpu", "gpu maps"}) {
        const Frames* const frames = measured.find(kRobots, name);
        if (!frames) continue;
        if (!frames->failure.empty()) {
            bars.push_back({{"way", name}, {"unavailable", frames->failure}});
            continue;
        }
        const std::vector<double> parts = parts_of(*frames);
        const std::vector<double> shares = shares_of(parts);
        shown.push_back({{"name", name}, {"values", shares}});
        Json ms = Json::object(), share = Json::object();
        for (std::size_t k = 0; k < kParts.size(); ++k) {
            ms[kParts[k]] = parts[k];
            share[kParts[k]] = shares[k];
        }
        bars.push_back({{"way", name}, {"ms", ms}, {"percent", share}});
    }
    const double items = paper_item_share();
    shown.push_back(
        {{"name", "paper, CPU (table 2)"}, {"values", {0, items, 0, 0, 0, 100 - items}}});
    report.page.add_bars({{"title", "Figure 8: where the time goes, robots"},
        {"label", "share of the frame, %"}, {"parts", kParts}, {"bars", std::move(shown)},
        {"caption",
            fmt::format(
                "Medians by stage. Stages that run on all threads count as their mean over the "
                "threads. \"waiting and the rest\" is what stages leave of the frame: threads that "
                "wait for each other, and of the hybrid engine rays that wait for items. The paper "
                "draws its figure 8 without numbers and calls the item buffer almost negligible; "
                "by its table 2 that is {:.1f} % of the frame, and how the rest is divided is not "
                "told. A graphics card drew its item buffer; a software driver takes the cores "
                "that the rays want.",
                items)}});
    json["figure8"] = {{"bars", std::move(bars)}, {"paper_item_buffer_percent", items}};
}

std::vector<Way> animation_ways()
{
    return {paper_way("hybrid"), paper_way("gpu"), paper_way("cpu"), paper_way("cpu maps"),
        paper_way("cpu exact")};
}

void add_animation(const PaperScene& robots, const std::vector<Frames>& frames, int rounds,
    Report& report, Json& json)
{
    const std::vector<Way> ways = animation_ways();
    Json series = Json::array(), curves = Json::array();
    std::string missing;
    for (std::size_t way = 0; way < ways.size(); ++way) {
        if (!frames[way].failure.empty()) {
            curves.push_back({{"way", ways[way].name}, {"unavailable", frames[way].failure}});
            missing += fmt::format(" {}: {}.", ways[way].name, frames[way].failure);
            continue;
        }
        Json time = Json::array(), fps = Json::array();
        std::vector<double> medians;
        for (int k = 0; k < rounds; ++k) {
            std::vector<double> ms;
            for (std::size_t i = std::size_t(k); i < frames[way].ms.size();
                 i += std::size_t(rounds))
                ms.push_back(frames[way].ms[i]);
            const double seconds = frame_time(*robots.scene, k, rounds);
            medians.push_back(quartiles(std::move(ms)).median);
            time.push_back(seconds);
            fps.push_back(1000 / medians.back());
        }
        series.push_back({{"name", ways[way].name}, {"x", time}, {"y", fps}});
        curves.push_back({{"way", ways[way].name}, {"time_s", std::move(time)},
            {"fps", std::move(fps)}, {"all", quartiles_json(per_second(quartiles(medians)))}});
    }
    const auto [begin, end] = std::pair(robots.scene->begin_s(), robots.scene->end_s());
    series.push_back({{"name", "paper, CPU: mean (table 4)"}, {"x", {begin, end}},
        {"y", {kFigure9Fps, kFigure9Fps}}, {"dashed", true}});
    report.page.add_curves({{"title", "Figure 9: frames per second over the animation, robots"},
        {"x", {{"label", "time in the animation, seconds"}, {"from_zero", false}}},
        {"y", {{"label", "frames per second"}, {"log", true}}}, {"series", std::move(series)},
        {"caption", "Each point is the median of a frame's repetitions. The paper draws a curve "
                    "without numbers, of the CPU without multisampling, and finds it more or less "
                    "constant." +
                        missing}});
    json["figure9"] = {{"curves", std::move(curves)}, {"paper_fps", kFigure9Fps}};
}

} // namespace firsthit::cli::bench
