// coverage.cpp - the share of each pixel's samples that see a surface.
#include "render/coverage.h"

#include "cpu/adaptive/adaptive_frame.h"
#include "cpu/finer_view.h"

#include <firsthit/scene.h>

#include <algorithm>

namespace firsthit {
namespace {

/// So many samples are looked at together: 64 MB of items.
constexpr std::size_t kSamplesAtOnce = std::size_t(1) << 24;

/// Counts the samples of pixels that see a surface.
///
/// items  of whole rows of pixels, each of n x n samples
void store_shares(const Film& items, int n, float* alpha)
{
    const auto width = std::size_t(items.width), step = std::size_t(n);
    const std::size_t columns = width / step, rows = std::size_t(items.height) / step;
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            int seen = 0;
            for (std::size_t sample_y = 0; sample_y < step; ++sample_y) {
                const std::uint32_t* const row =
                    &items.item[(y * step + sample_y) * width + x * step];
                seen += int(step - std::size_t(std::count(row, row + step, kNoItem)));
            }
            alpha[y * columns + x] = float(seen) / float(n * n);
        }
    }
}

} // namespace

void Coverage::fill(const FrameContext& frame, const Settings& settings)
{
    Settings items = settings;
    items.color = false;
    items.alpha = false;
    items.aovs = {Aov::item};
    items.shadows = Shadows::none;
    items.samples = items.interleave = items.adaptive = 1;
    const Region& all = frame.view.region;
    const bool fine = wants_edges(settings) && settings.engine != Engine::gpu;
    const int n = fine ? settings.adaptive : settings.samples;
    const std::size_t row_samples = std::size_t(all.width) * std::size_t(n) * std::size_t(n);
    const int rows_at_once = int(std::max<std::size_t>(1, kSamplesAtOnce / row_samples));
    frame.film.alpha.channels = 1;
    frame.film.alpha.value.resize(std::size_t(all.width) * std::size_t(all.height));
    Stats ignored;
    for (int y = 0; y < all.height; y += rows_at_once) {
        if (frame.progress) frame.progress->check();
        View part = frame.view;
        part.region = {all.x, all.y + y, all.width, std::min(rows_at_once, all.height - y)};
        const View samples = finer(part, n);
        render_surfaces({frame.world, samples, frame.tasks, items_}, items, memory_, ignored, {});
        store_shares(
            items_, n, frame.film.alpha.value.data() + std::size_t(y) * std::size_t(all.width));
    }
}

} // namespace firsthit
