// adaptive_frame.cpp - frames with N x N samples where a pixel may hold an edge.
#include "cpu/adaptive/adaptive_frame.h"

#include "base/stopwatch.h"
#include "cpu/adaptive/edge_finder.h"
#include "cpu/frame.h"
#include "film/film_size.h"

#include <algorithm>

namespace firsthit {
namespace {

/// Samples of a section with layers, on a side: their layers take 50 bytes a sample.
constexpr int kLayerSide = 1024;

/// The region and the pixels around it, by whole blocks of 8x8 pixels of the picture: what is hidden is
/// found by such blocks (EdgeMemory).
Region surroundings(const View& view)
{
    const Region& region = view.region;
    constexpr int kAround = EdgeFinder::kAround;
    const auto before = [](int first) { return std::max(first - kAround, 0) / kBlock * kBlock; };
    const auto after = [](int end, int size) {
        return std::min((end + kAround + kBlock - 1) / kBlock * kBlock, size);
    };
    const int x = before(region.x), y = before(region.y);
    return {x, y, after(region.x + region.width, view.width) - x,
        after(region.y + region.height, view.height) - y};
}

/// Copies rows of a part of a film, where both films have the values.
///
/// from_region, part  in pixels of the picture; the part lies in both
template <class Values>
void copy_part(const Values& from, const Region& from_region, const Region& part,
    std::size_t channels, Values& to)
{
    if (from.empty() || to.empty()) return;
    const std::size_t count = std::size_t(part.width) * channels;
    for (int y = 0; y < part.height; ++y) {
        const std::size_t first =
            (std::size_t(part.y - from_region.y + y) * std::size_t(from_region.width) +
                std::size_t(part.x - from_region.x)) *
            channels;
        std::copy_n(from.data() + first, count, to.data() + std::size_t(y) * count);
    }
}

/// Makes the film that of a part of another one, with the same planes.
void crop(const Film& from, const Region& from_region, const Region& part, Film& film)
{
    copy_part(from.color.value, from_region, part, 3, film.color.value);
    copy_part(from.item, from_region, part, 1, film.item);
    film.alpha.channels = 1;
    film.alpha.value.resize(
        from.alpha.empty() ? 0 : std::size_t(part.width) * std::size_t(part.height));
    copy_part(from.alpha.value, from_region, part, 1, film.alpha.value);
    for (std::size_t k = 0; k < from.aov.size(); ++k)
        copy_part(from.aov[k].value, from_region, part, std::size_t(from.aov[k].channels),
            film.aov[k].value);
}

/// The frame of one sample a pixel, and the marks.
void render_coarse(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, FrameSources sources)
{
    AdaptiveMemory& own = memory.adaptive;
    const Region& all = frame.view.region;
    View view = frame.view;
    view.region = surroundings(view);
    own.marks.clear(view.region, settings.adaptive);
    const bool whole = all.width == view.region.width && all.height == view.region.height;
    Film& film = whole ? frame.film : own.film;
    const FrameContext coarse{frame.world, view, frame.tasks, film, frame.progress};
    EdgeFinder edges(coarse, own.edges, own.marks);
    sources.edges = &edges;
    render_frame(coarse, own.coarse, memory, stats, sources);
    Stopwatch watch;
    edges.find_contrast(film.color);
    if (!whole) {
        resize(frame.film, all, {true, settings.aovs, frame.world.lights.size()});
        crop(film, view.region, all, frame.film);
    }
    stats.mark_ms += edges.take_ms() + watch.lap_ms();
}

/// N x N samples of the marked pixels of a scene with layers, section by section.
void render_fine_layers(const FrameContext& frame, FrameMemory& memory, Stats& stats)
{
    AdaptiveMemory& own = memory.adaptive;
    const Region& all = frame.view.region;
    const int side = std::max(1, kLayerSide / own.fine.samples);
    View view = frame.view;
    Region& part = view.region;
    for (int y = 0; y < all.height; y += side) {
        for (int x = 0; x < all.width; x += side) {
            part = {all.x + x, all.y + y, std::min(side, all.width - x),
                std::min(side, all.height - y)};
            if (own.marks.count(part) == 0) continue;
            render_layers({frame.world, view, frame.tasks, own.film, frame.progress}, own.fine,
                memory, stats, {.only = &own.marks});
            for (int py = 0; py < part.height; ++py) {
                for (int px = 0; px < part.width; ++px) {
                    if (!own.marks.has(part.x + px, part.y + py)) continue;
                    const std::size_t from = std::size_t(py * part.width + px);
                    const std::size_t to =
                        std::size_t(y + py) * std::size_t(all.width) + std::size_t(x + px);
                    std::copy_n(
                        &own.film.color.value[3 * from], 3, &frame.film.color.value[3 * to]);
                    if (!own.film.alpha.empty())
                        frame.film.alpha.value[to] = own.film.alpha.value[from];
                }
            }
        }
    }
}

} // namespace

bool wants_edges(const Settings& settings)
{
    return settings.adaptive > 1 && settings.color && settings.samples == 1 &&
           settings.interleave == 1;
}

void render_adaptively(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources)
{
    AdaptiveMemory& own = memory.adaptive;
    own.film.alpha.value.clear();
    own.coarse = settings;
    own.coarse.adaptive = 1;
    own.fine = own.coarse;
    own.fine.aovs.clear();
    own.fine.samples = settings.adaptive;
    render_coarse(frame, settings, memory, stats, sources);

    Stopwatch watch;
    const std::uint64_t marked = own.marks.count(frame.view.region);
    stats.fine_pixels += marked;
    if (marked == 0) return;
    if (has_layers(frame.world, own.fine))
        render_fine_layers(frame, memory, stats);
    else
        render_surfaces(frame, own.fine, memory, stats, {.only = &own.marks});
    stats.fine_ms += watch.lap_ms();
}

} // namespace firsthit
