// pixel_marks.cpp - the pixels of a picture that get N x N samples.
#include "cpu/adaptive/pixel_marks.h"

#include <algorithm>

namespace firsthit {
namespace {

/// The pixels that a range of samples touches, cut off at those from `begin` to `end`.
struct PixelSpan {
    int first, last; // inside

    PixelSpan(int sample, int count, int n, int begin, int end)
        : first(std::max(sample / n, begin)),
          last(std::min((sample + count - 1) / n, end - 1))
    {
    }
};

} // namespace

void PixelMarks::clear(const Region& all, int n)
{
    region = all;
    samples = n;
    pixel.resize(std::size_t(all.width) * std::size_t(all.height));
    std::fill_n(pixel.data(), pixel.size(), std::uint8_t(0));
}

std::uint64_t PixelMarks::count(const Region& part) const
{
    std::uint64_t sum = 0;
    for (int y = part.y; y < part.y + part.height; ++y) {
        const std::uint8_t* row = &pixel[index_of(part.x, y)];
        for (int x = 0; x < part.width; ++x) sum += row[x];
    }
    return sum;
}

void wanted_samples(
    const PixelMarks& marks, const SamplePlace& first, int size, std::span<std::uint64_t> wanted)
{
    const Region& region = marks.region;
    const int n = marks.samples;
    std::fill(wanted.begin(), wanted.end(), std::uint64_t(0));
    const PixelSpan columns(first.x, size, n, region.x, region.x + region.width);
    const PixelSpan rows(first.y, size, n, region.y, region.y + region.height);
    for (int py = rows.first; py <= rows.last; ++py) {
        for (int px = columns.first; px <= columns.last; ++px) {
            if (!marks.has(px, py)) continue;
            const int x0 = std::max(px * n - first.x, 0), x1 = std::min(px * n - first.x + n, size);
            const int y0 = std::max(py * n - first.y, 0), y1 = std::min(py * n - first.y + n, size);
            for (int y = y0; y < y1; ++y) {
                for (int x = x0; x < x1; ++x) {
                    const int at = tile_offset(x, y, size);
                    wanted[std::size_t(at / kBlockSamples)] |= std::uint64_t(1)
                                                               << at % kBlockSamples;
                }
            }
        }
    }
}

void wanted_blocks(const PixelMarks& marks, const SamplePlace& first, const TileLayout& layout,
    BlockBits& blocks, std::vector<std::uint32_t>& tiles)
{
    const Pencil& pencil = layout.pencil;
    const Region& region = marks.region;
    const int n = marks.samples;
    blocks.clear(pencil.width, pencil.height);
    const PixelSpan columns(first.x, pencil.width, n, region.x, region.x + region.width);
    const PixelSpan rows(first.y, pencil.height, n, region.y, region.y + region.height);
    for (int py = rows.first; py <= rows.last; ++py) {
        const int y0 = std::max(py * n - first.y, 0),
                  y1 = std::min(py * n - first.y + n, pencil.height) - 1;
        for (int px = columns.first; px <= columns.last; ++px) {
            if (!marks.has(px, py)) continue;
            const int x0 = std::max(px * n - first.x, 0),
                      x1 = std::min(px * n - first.x + n, pencil.width) - 1;
            for (int by = y0 / kBlock; by <= y1 / kBlock; ++by)
                for (int bx = x0 / kBlock; bx <= x1 / kBlock; ++bx) blocks.set(bx, by);
        }
    }
    tiles.clear();
    const int side = layout.tile_size / kBlock;
    for (int tile = 0; tile < layout.tiles(); ++tile) {
        const int bx = layout.first_x(tile) / kBlock, by = layout.first_y(tile) / kBlock;
        if (blocks.any({bx, by, bx + side - 1, by + side - 1}))
            tiles.push_back(std::uint32_t(tile));
    }
}

} // namespace firsthit
