// sun_span.cpp - the sun over a span of time, step by step.
#include "inputs/sun_span.h"

#include "common/parse.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace firsthit::cli {
namespace {

constexpr double kMostSteps = 1e6;

double step_of(const std::string& text)
{
    const char unit = text.empty() ? ' ' : text.back();
    const double seconds = unit == 's' ? 1 : unit == 'm' ? 60 : unit == 'h' ? 3600 : 0;
    if (seconds == 0)
        throw UsageError(
            fmt::format("'{}' is no step: accepted are seconds, minutes and hours, as 900s, 15m or "
                        "1h",
                text));
    const double step = parse_number(text.substr(0, text.size() - 1)) * seconds;
    if (!(step >= 1 && step <= 366 * 86400.0))
        throw UsageError(fmt::format("the step '{}' is out of range: a second to a year", text));
    return step;
}

} // namespace

SunSpan parse_sun_span(const std::string& text)
{
    std::vector<std::string> words;
    for (std::size_t first = 0;;) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        words.push_back(text.substr(first, end - first));
        if (end == text.size()) break;
        first = end + 1;
    }
    if (words.size() != 5)
        throw UsageError(
            fmt::format("'{}' is no span of the sun: accepted is LAT,LON,FROM,TO,STEP, as "
                        "52.5,13.4,2026-06-21T00:00+02:00,2026-06-22T00:00+02:00,15m",
                text));
    SunSpan span;
    span.latitude_deg = parse_number(words[0]);
    span.longitude_deg = parse_number(words[1]);
    try {
        span.from_s = unix_time(words[2]);
        span.to_s = unix_time(words[3]);
        (void)sun_position(span.latitude_deg, span.longitude_deg, span.from_s);
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
    span.step_s = step_of(words[4]);
    if (!(span.to_s > span.from_s))
        throw UsageError(fmt::format("the span '{}' ends before it begins", text));
    if (!((span.to_s - span.from_s) / span.step_s <= kMostSteps))
        throw UsageError(fmt::format("the span '{}' has more than a million steps", text));
    return span;
}

std::vector<SunStep> sun_steps(const SunSpan& span, double north_deg)
{
    std::vector<SunStep> steps;
    const auto count =
        static_cast<std::size_t>(std::ceil((span.to_s - span.from_s) / span.step_s - 1e-9));
    for (std::size_t k = 0; k < std::max<std::size_t>(1, count); ++k) {
        const double from = span.from_s + static_cast<double>(k) * span.step_s;
        const double length = std::min(span.step_s, span.to_s - from);
        SunStep step{.hours = length / 3600, .direction = {}};
        SunPosition sun = sun_position(span.latitude_deg, span.longitude_deg, from + 0.5 * length);
        sun.azimuth_rad += north_deg * std::numbers::pi / 180;
        if (sun.elevation_rad > 0) step.direction = -to_sun(sun);
        steps.push_back(step);
    }
    return steps;
}

} // namespace firsthit::cli
