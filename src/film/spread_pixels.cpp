// spread_pixels.cpp - makes a picture of which only every few pixels are known.
//
// What surrounds a pixel depends on its place between the steps alone. So there are steps.x * steps.y lists
// of neighbours ("taps"), in the order in which fill_holes adds them, and a row is made list by list: one
// list adds up whole rows of known pixels, shifted. Near the borders of the region, where neighbours may be
// missing, each pixel makes its own list.
#include "film/spread_pixels.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace firsthit {
namespace {

constexpr int kMostColumns = 4; // PixelSteps::of(PixelSteps::kMost).x
static_assert(PixelSteps::of(PixelSteps::kMost).x == kMostColumns);
static_assert(PixelSteps::of(PixelSteps::kMost).y <= kMostColumns);

/// A known pixel beside one that is not.
struct Tap {
    int dx, dy; // in pixels
    float share;
};

/// The known pixels that a pixel is made of: those of one ring, whose reach is below the steps.
struct Taps {
    std::array<Tap, 8 * kMostColumns> tap;
    int count = 0;
    float weight = 0;

    std::span<const Tap> all() const { return std::span(tap).first(std::size_t(count)); }
};

/// x, y  of the picture
Taps taps_of(const PixelSteps& steps, int x, int y, const Region& region)
{
    Taps taps;
    for (int reach = 1; taps.count == 0 && reach < kMostColumns; ++reach) {
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; dx += std::abs(dy) == reach ? 1 : 2 * reach) {
                const int px = x + dx, py = y + dy;
                if (px < region.x || px >= region.x + region.width || py < region.y ||
                    py >= region.y + region.height || !steps.is_shot(px, py))
                    continue;
                const float share = 1.0f / float(dx * dx + dy * dy);
                taps.tap[std::size_t(taps.count++)] = {dx, dy, share};
                taps.weight += share;
            }
        }
    }
    return taps;
}

/// One row of the region that is being made.
class SpreadRow {
  public:
    /// row  of the region
    SpreadRow(const SpreadPicture& picture, int row)
        : picture_(picture),
          steps_(picture.steps),
          shot_(picture.steps.shot(picture.region)),
          y_(picture.region.y + row),
          to_(&picture.color[3 * std::size_t(row) * std::size_t(picture.region.width)])
    {
    }

    /// Makes the pixels of columns [first, last) of the picture, one by one. Returns how many were not known.
    int make(int first, int last) const
    {
        int made = 0;
        for (int x = first; x < last; ++x) {
            float* to = to_ + 3 * (x - picture_.region.x);
            if (steps_.is_shot(x, y_)) {
                std::copy_n(known(x, y_), 3, to);
                continue;
            }
            const Taps taps = taps_of(steps_, x, y_, picture_.region);
            if (taps.count == 0) continue;
            float sum[3] = {};
            for (const Tap& tap : taps.all())
                for (int c = 0; c < 3; ++c) sum[c] += tap.share * known(x + tap.dx, y_ + tap.dy)[c];
            for (int c = 0; c < 3; ++c) to[c] = sum[c] / taps.weight;
            ++made;
        }
        return made;
    }

    /// The same of columns that are all farther from the region's borders than taps reach. Both are multiples
    /// of steps.x.
    int make_inner(int first, int last) const
    {
        constexpr int kChunk = 128; // known pixels of a row at once
        const Region endless{0, 0, 16 * kMostColumns, 16 * kMostColumns};
        std::array<Taps, kMostColumns> taps;
        for (int k = 0; k < steps_.x; ++k)
            taps[std::size_t(k)] =
                taps_of(steps_, 8 * kMostColumns + k, 8 * kMostColumns + y_ % steps_.y, endless);
        const bool shot = y_ % steps_.y == 0;
        float made[kMostColumns][3 * kChunk];
        for (int x = first; x < last; x += kChunk * steps_.x) {
            const int columns = std::min(kChunk, (last - x) / steps_.x);
            for (int k = 0; k < steps_.x; ++k) {
                if (k == 0 && shot)
                    std::copy_n(known(x, y_), 3 * columns, made[0]);
                else
                    add_up(taps[std::size_t(k)], x + k, 3 * columns, made[k]);
            }
            float* to = to_ + 3 * (x - picture_.region.x);
            for (int column = 0; column < columns; ++column)
                for (int k = 0; k < steps_.x; ++k, to += 3)
                    for (int c = 0; c < 3; ++c) to[c] = made[k][3 * column + c];
        }
        return (last - first) - (shot ? (last - first) / steps_.x : 0);
    }

  private:
    const float* known(int x, int y) const
    {
        return &picture_.known[3 * (std::size_t(y / steps_.y - shot_.y) * std::size_t(shot_.width) +
                                       std::size_t(x / steps_.x - shot_.x))];
    }

    /// The pixels x, x + steps.x, ..., as `count` floats.
    void add_up(const Taps& taps, int x, int count, float* to) const
    {
        std::fill_n(to, count, 0.0f);
        for (const Tap& tap : taps.all()) {
            const float* from = known(x + tap.dx, y_ + tap.dy);
            const float share = tap.share;
            for (int j = 0; j < count; ++j) to[j] += share * from[j];
        }
        const float weight = taps.weight;
        for (int j = 0; j < count; ++j) to[j] /= weight;
    }

    const SpreadPicture& picture_;
    const PixelSteps steps_;
    const Region shot_;
    int y_;
    float* to_;
};

} // namespace

std::uint64_t spread_pixels(const SpreadPicture& picture, int first, int last)
{
    const PixelSteps& steps = picture.steps;
    const Region& region = picture.region;
    const Region shot = steps.shot(region);
    if (shot.width <= 0 || shot.height <= 0) return 0;
    const int left = region.x, right = region.x + region.width;
    const int inner_left = (left + 2 * steps.x - 1) / steps.x * steps.x;
    const int inner_right = std::max((right - steps.x) / steps.x * steps.x, inner_left);
    std::uint64_t made = 0;
    for (int row = first; row < last; ++row) {
        const SpreadRow to(picture, row);
        const bool inner = row >= kMostColumns && row < region.height - kMostColumns &&
                           inner_right > inner_left && region.width > 4 * kMostColumns;
        if (inner) {
            made += std::uint64_t(to.make(left, inner_left));
            made += std::uint64_t(to.make_inner(inner_left, inner_right));
            made += std::uint64_t(to.make(inner_right, right));
        } else {
            made += std::uint64_t(to.make(left, right));
        }
    }
    return made;
}

void place_pixels(const SpreadPicture& picture, int first, int last)
{
    const Region& region = picture.region;
    const Region shot = picture.steps.shot(region);
    const float* from = picture.known.data();
    for (int y = 0; y < shot.height; ++y) {
        const int row = (shot.y + y) * picture.steps.y - region.y;
        if (row < first || row >= last) continue;
        for (int x = 0; x < shot.width; ++x) {
            const int column = (shot.x + x) * picture.steps.x - region.x;
            const std::size_t at =
                std::size_t(row) * std::size_t(region.width) + std::size_t(column);
            std::copy_n(from + 3 * (y * shot.width + x), 3, &picture.color[3 * at]);
        }
    }
}

} // namespace firsthit
