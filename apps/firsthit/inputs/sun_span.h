// sun_span.h - the sun over a span of time, step by step.
#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

/// What --sun says: LAT,LON,FROM,TO,STEP.
struct SunSpan {
    double latitude_deg = 0, longitude_deg = 0;
    double from_s = 0, to_s = 0; // since 1970
    double step_s = 0;
};

/// "52.5,13.4,2026-06-21T00:00+02:00,2026-06-22T00:00+02:00,15m": two times in ISO 8601 with their zones, and a step in
/// seconds, minutes or hours (s, m, h). At most a million steps.
/// throws  UsageError: what is wrong, and what is accepted
SunSpan parse_sun_span(const std::string& text);

/// One step.
struct SunStep {
    double hours = 0; // how long it is; the last one may be shorter
    /// From the sun to the ground in a world with y up, x east and z south, in the middle of the step. None: it is below
    /// the horizon.
    std::optional<glm::dvec3> direction;
};

/// The steps from `from_s` on.
/// north_deg  where north is, clockwise seen from above, from where it is without it
std::vector<SunStep> sun_steps(const SunSpan& span, double north_deg);

} // namespace firsthit::cli
