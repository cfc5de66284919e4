// engine_report.cpp - how far an engine agrees with the cpu engine, as a table and as JSON.
#include "engine_report.h"

#include <fmt/format.h>

#include <cmath>

namespace firsthit::cli {

namespace {

Json decibels_json(double decibels)
{
    return std::isinf(decibels) ? Json(nullptr) : Json(decibels);
}

std::string decibels_text(double decibels)
{
    return std::isinf(decibels) ? "equal" : fmt::format("{:.2f} dB", decibels);
}

} // namespace

Json engine_comparison_json(const EngineComparison& comparison, const std::string& device)
{
    Json json = {
        {"pixels", comparison.pixels},
        {"missed", comparison.missed},
        {"wrong", comparison.wrong},
        {"ties", comparison.ties},
        {"interpolated", comparison.interpolated},
        {"psnr_db", decibels_json(comparison.psnr_db())},
        {"largest_difference", comparison.largest_difference},
    };
    if (const auto lent = comparison.psnr_same_items_db())
        json["psnr_same_items_db"] = decibels_json(*lent);
    json["device"] = device;
    return json;
}

std::string engine_comparison_text(const EngineComparison& comparison, const std::string& device)
{
    const auto count = [&](const char* name, std::uint64_t value) {
        return fmt::format("{:<20} {:>12}  {:>9.4f} %\n", name, value,
            100 * double(value) / double(comparison.pixels));
    };
    std::string text = fmt::format("{:<20} {:>12}\n", "pixels", comparison.pixels);
    text += count("missed", comparison.missed);
    text += count("wrong", comparison.wrong);
    text += count("ties", comparison.ties);
    text += count("interpolated", comparison.interpolated);
    text += fmt::format("{:<20} {:>12}\n", "PSNR", decibels_text(comparison.psnr_db()));
    text += fmt::format("{:<20} {:>12.6f}\n", "largest difference", comparison.largest_difference);
    if (const auto lent = comparison.psnr_same_items_db())
        text += fmt::format("{:<20} {:>12}\n", "PSNR, same items", decibels_text(*lent));
    return text + fmt::format("{:<20} {}\n", "device", device);
}

} // namespace firsthit::cli
