// stages.cpp - the stages of a frame that bars show, with their colours.
#include "view/session/stages.h"

#include <algorithm>

namespace firsthit::cli::view {
namespace {

constexpr std::array<Stage, 10> kStages = {{
    {"pose", &Stats::pose_ms, {120, 144, 156}},
    {"set-up", &Stats::setup_ms, {94, 129, 244}},
    {"raster", &Stats::raster_ms, {66, 184, 221}},
    {"draw", &Stats::draw_ms, {120, 94, 240}},
    {"wait", &Stats::wait_ms, {150, 110, 90}},
    {"resolve", &Stats::resolve_ms, {84, 190, 120}},
    {"shadow", &Stats::shadow_ms, {235, 170, 60}},
    {"sky", &Stats::sky_ms, {150, 200, 250}},
    {"shade", &Stats::shade_ms, {226, 92, 92}},
    {"mark", &Stats::mark_ms, {200, 120, 200}},
}};

} // namespace

std::span<const Stage> all_stages()
{
    return kStages;
}

double other_ms(const Stats& stats, double made_ms)
{
    double told = 0;
    for (const Stage& stage : kStages) told += stats.*stage.ms;
    return std::max(0.0, made_ms - told);
}

} // namespace firsthit::cli::view
