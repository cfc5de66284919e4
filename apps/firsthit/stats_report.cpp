// stats_report.cpp - where the time went, as a table and as JSON.
#include "stats_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <iterator>

namespace firsthit::cli {

namespace {

struct Stage {
    const char* name;
    double Stats::*ms;
};

constexpr Stage kStages[] = {
    {"pose", &Stats::pose_ms},
    {"setup", &Stats::setup_ms},
    {"raster", &Stats::raster_ms},
    {"resolve", &Stats::resolve_ms},
    {"shadow", &Stats::shadow_ms},
    {"shadow_collect", &Stats::shadow_collect_ms},
    {"shadow_sort", &Stats::shadow_sort_ms},
    {"shadow_test", &Stats::shadow_test_ms},
    {"sky", &Stats::sky_ms},
    {"shade", &Stats::shade_ms},
    {"mark", &Stats::mark_ms},
    {"fine", &Stats::fine_ms},
    {"draw", &Stats::draw_ms},
    {"transfer", &Stats::transfer_ms},
    {"wait", &Stats::wait_ms},
    {"write", &Stats::write_ms},
    {"total", &Stats::total_ms},
};

/// What took less would be a row of zeros.
constexpr double kLeastShownMs = 0.005;

struct Count {
    const char* name;
    const char* key;
    std::uint64_t Stats::*value;
};

constexpr Count kCounts[] = {
    {"vertices", "vertices", &Stats::vertices},
    {"triangles", "triangles", &Stats::triangles},
    {"in view", "in_view", &Stats::in_view},
    {"tile entries", "tile_entries", &Stats::tile_entries},
    {"uncertain lanes", "uncertain_lanes", &Stats::uncertain_lanes},
    {"ambiguous lanes", "ambiguous_lanes", &Stats::ambiguous_lanes},
    {"exact calls", "exact_calls", &Stats::exact_calls},
    {"hits", "hits", &Stats::hits},
    {"uncertain pixels", "uncertain_samples", &Stats::uncertain_samples},
    {"missed", "missed", &Stats::missed},
    {"interpolated", "interpolated", &Stats::interpolated},
    {"fine pixels", "fine_pixels", &Stats::fine_pixels},
    {"shadow points", "shadow_points", &Stats::shadow_points},
    {"shadow triangles", "shadow_triangles", &Stats::shadow_triangles},
    {"shadow pairs", "shadow_pairs", &Stats::shadow_pairs},
    {"shadow uncertain", "shadow_uncertain", &Stats::shadow_uncertain},
    {"sky points", "sky_points", &Stats::sky_points},
    {"map updates", "map_updates", &Stats::map_updates},
    {"uploaded bytes", "uploaded_bytes", &Stats::uploaded_bytes},
};

template <class T>
struct MeanAndMax {
    double mean = 0;
    T max{};
};

template <class T>
MeanAndMax<T> over_frames(const RunReport& report, T Stats::*member)
{
    MeanAndMax<T> result;
    for (const FrameReport& frame : report.frames) {
        result.mean += static_cast<double>(frame.stats.*member);
        result.max = std::max(result.max, frame.stats.*member);
    }
    result.mean /= static_cast<double>(report.frames.size());
    return result;
}

} // namespace

std::string stats_table(const RunReport& report)
{
    std::string text;
    const auto out = std::back_inserter(text);
    const bool several = report.frames.size() > 1;
    fmt::format_to(out, "{}, {}x{}, {} ray{} a pixel{}, {} thread{}, {}, {} frame{}\n",
        report.scene, report.width, report.height, report.samples * report.samples,
        report.samples == 1 ? "" : "s",
        report.adaptive > 1 ? fmt::format(", {} at edges", report.adaptive * report.adaptive)
                            : std::string(),
        report.threads, report.threads == 1 ? "" : "s", report.instruction_set,
        report.frames.size(), several ? "s" : "");
    fmt::format_to(
        out, "engine {}{}{}\n", report.engine, report.device.empty() ? "" : " on ", report.device);
    fmt::format_to(out, "{:<16}{:>12}{}\n", "stage", several ? "mean ms" : "ms",
        several ? "      max ms" : "");
    fmt::format_to(out, "{:<16}{:>12.2f}\n", "load", report.load_ms);
    for (const Stage& stage : kStages) {
        const auto ms = over_frames(report, stage.ms);
        if (ms.max < kLeastShownMs) continue;
        fmt::format_to(out, "{:<16}{:>12.2f}", stage.name, ms.mean);
        if (several) fmt::format_to(out, "{:>12.2f}", ms.max);
        text += '\n';
    }
    fmt::format_to(
        out, "{:<16}{:>12}{}\n", "count", several ? "mean" : "", several ? "         max" : "");
    for (const Count& count : kCounts) {
        const auto value = over_frames(report, count.value);
        if (value.max == 0) continue;
        fmt::format_to(out, "{:<16}{:>12.0f}", count.name, value.mean);
        if (several) fmt::format_to(out, "{:>12}", value.max);
        text += '\n';
    }
    fmt::format_to(out, "{:<16}{:>12.1f} MB\n", "peak memory",
        static_cast<double>(report.peak_memory_bytes) / 1e6);
    return text;
}

Json stats_json(const RunReport& report)
{
    Json json = {
        {"scene", report.scene},
        {"width", report.width},
        {"height", report.height},
        {"samples", report.samples},
        {"adaptive", report.adaptive},
        {"threads", report.threads},
        {"instruction_set", report.instruction_set},
        {"engine", report.engine},
        {"device", report.device},
        {"load_ms", report.load_ms},
        {"peak_memory_bytes", report.peak_memory_bytes},
        {"frames", Json::array()},
    };
    for (const FrameReport& frame : report.frames) {
        Json entry = {{"time_s", frame.time_s}};
        for (const Stage& stage : kStages)
            entry[std::string(stage.name) + "_ms"] = frame.stats.*stage.ms;
        for (const Count& count : kCounts) entry[count.key] = frame.stats.*count.value;
        json["frames"].push_back(std::move(entry));
    }
    return json;
}

std::uint64_t peak_memory_bytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024; // Linux counts kilobytes
}

} // namespace firsthit::cli
