// frame_plan.cpp - plans which stages a frame of the cpu engine runs, and what is kept between
// them.
#include "cpu/frame_plan.h"

#include "base/tile_order.h"
#include "cpu/frame.h"
#include "exact/pencil.h"

#include <algorithm>
#include <numeric>

namespace firsthit {
namespace {

/// Samples on a side of a part whose hits are kept for the lights. They take 100 MB for exact
/// shadows and 400 MB for shadow maps, which have larger parts so that a map is seldom made several
/// times.
constexpr int kExactSide = 2048;
constexpr int kMapSide = 4096;

/// The number of samples on a side of a tile: about tile_size, but whole blocks and whole pixels.
int tile_samples(int tile_size, int samples)
{
    const int step = std::lcm(kBlock, samples);
    return std::min((tile_size + step - 1) / step * step, kMaxTile / step * step);
}

} // namespace

FramePlan::FramePlan(
    const Settings& settings, std::size_t lights, bool exact_items, const FrameSources& sources)
    : shadows_(settings),
      sky_(settings.sky)
{
    const std::span<const Aov> planes = settings.aovs;
    const bool shadows = settings.shadows != Shadows::none && lights > 0;
    const bool lit = std::find(planes.begin(), planes.end(), Aov::lit) != planes.end();
    // Planes show what the ray through the centre of every pixel sees. If pixels have several
    // samples, or not all pixels are shot for colour, planes are made in a second pass.
    const bool together = settings.samples == 1 && settings.interleave == 1;
    if (settings.color || together)
        add({.samples = settings.samples,
                .color = settings.color,
                .aovs = together ? planes : std::span<const Aov>(),
                .shadows = shadows && (settings.color || lit),
                .sky = settings.color && sky_.directions > 0,
                .steps = PixelSteps::of(settings.interleave),
                .fill = settings.color && settings.interpolate && !exact_items,
                .edges = settings.color ? sources.edges : nullptr,
                .only = sources.only},
            settings.tile_size);
    if (!together && !planes.empty())
        add({.color = false, .aovs = planes, .shadows = shadows && lit}, settings.tile_size);
}

void FramePlan::add(PassPlan pass, int tile_size)
{
    const bool by_map = shadows_.shadows == Shadows::map;
    pass.tile_size = tile_samples(tile_size, pass.samples);
    pass.keeps_misses = !pass.aovs.empty() || pass.edges;
    pass.keeps_items = pass.keeps_misses || (pass.shadows && !by_map) || pass.sky;
    // Limits of the integers in InView and TileLayout::tile_of.
    int side = std::min(kMaxPencil, 255 * pass.tile_size);
    // Of marked pixels few hits are kept; a part with many is halved.
    if (pass.keeps_hits() && !pass.only)
        side = std::min(side, by_map && !pass.sky ? kMapSide : kExactSide);
    pass.part_side = side / pass.tile_size * pass.tile_size / pass.samples;
    pass_[count_++] = pass;
}

std::uint64_t FramePlan::work(const Region& region) const
{
    std::uint64_t sum = 0;
    for (const PassPlan& pass : passes()) sum += pass.work(pass.steps.shot(region));
    return sum;
}

} // namespace firsthit
