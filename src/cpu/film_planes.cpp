// film_planes.cpp - from tiles of samples to the planes of the film.
#include "cpu/film_planes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

bool contains(std::span<const Aov> aovs, Aov wanted)
{
    return std::find(aovs.begin(), aovs.end(), wanted) != aovs.end();
}

/// The tile's pixels inside the picture.
struct PixelRect {
    int film_x, film_y; // of the first pixel, in the film
    int width, height;  // pixels
};

PixelRect pixels_of(const TilePlace& place)
{
    const int side = place.view.tile_size / place.samples;
    const int x = place.tile % place.view.tiles_x * side, y = place.tile / place.view.tiles_x * side;
    return {place.part.x - place.region.x + x, place.part.y - place.region.y + y,
        std::min(side, place.part.width - x), std::min(side, place.part.height - y)};
}

/// Calls f(pixel in the film, offset in the tile) for runs of at most 4 pixels of a row; samples = 1.
template <class F> void for_quads(const PixelRect& rect, int film_width, int tile_size, const F& f)
{
    for (int y = 0; y < rect.height; ++y) {
        const std::size_t row = std::size_t(rect.film_y + y) * std::size_t(film_width);
        for (int x = 0; x < rect.width; x += 4)
            f(row + std::size_t(rect.film_x + x), tile_offset(x, y, tile_size),
                std::min(4, rect.width - x));
    }
}

template <int kChannels>
void copy_plane(const PixelRect& rect, int film_width, int tile_size,
    const float* const (&from)[kChannels], Plane& to)
{
    float* value = to.value.data();
    for_quads(rect, film_width, tile_size, [&](std::size_t pixel, int offset, int count) {
        for (int k = 0; k < count; ++k)
            for (int c = 0; c < kChannels; ++c)
                value[(pixel + std::size_t(k)) * kChannels + std::size_t(c)] = from[c][offset + k];
    });
}

/// The mean colour of each pixel's samples.
void average_color(const PixelRect& rect, const TilePlace& place, const float* const (&from)[3],
    Film& film)
{
    const int n = place.samples;
    const float share = 1.0f / float(n * n);
    for (int y = 0; y < rect.height; ++y) {
        for (int x = 0; x < rect.width; ++x) {
            float sum[3] = {};
            for (int sy = 0; sy < n; ++sy) {
                for (int sx = 0; sx < n; ++sx) {
                    const int offset = tile_offset(x * n + sx, y * n + sy, place.view.tile_size);
                    for (int c = 0; c < 3; ++c) sum[c] += from[c][offset];
                }
            }
            const std::size_t pixel = std::size_t(rect.film_y + y) * std::size_t(film.width) +
                std::size_t(rect.film_x + x);
            for (std::size_t c = 0; c < 3; ++c) film.color.value[pixel * 3 + c] = sum[c] * share;
        }
    }
}

/// Planes that come from the hit itself.
void store_hits(const PixelRect& rect, const HitTile& hits, Film& film)
{
    const auto none = std::numeric_limits<float>::infinity();
    std::uint32_t* item = film.item.empty() ? nullptr : film.item.data();
    const auto plane = [&](Aov a) { return film[a].empty() ? nullptr : film[a].value.data(); };
    float* depth = plane(Aov::depth);
    float* distance = plane(Aov::distance);
    float* barycentric = plane(Aov::barycentric);
    if (!item && !depth && !distance && !barycentric) return;
    const double inv_f = hits.frame.inv_f;
    for_quads(rect, film.width, hits.size, [&](std::size_t pixel, int offset, int count) {
        for (int k = 0; k < count; ++k, ++pixel, ++offset) {
            const bool hit = hits.item[offset] != kNoItem;
            if (item) item[pixel] = hits.item[offset];
            if (depth) depth[pixel] = hit ? hits.t[offset] : none;
            if (barycentric) {
                barycentric[2 * pixel] = hit ? hits.u[offset] : 0.0f;
                barycentric[2 * pixel + 1] = hit ? hits.v[offset] : 0.0f;
            }
            if (distance) {
                const int in_block = offset % kBlockSamples, block = offset / kBlockSamples;
                const int blocks_x = hits.size / kBlock;
                const double x = (double(hits.frame.x0) + block % blocks_x * kBlock + block_x(in_block)) * inv_f;
                const double y = (double(hits.frame.y0) + block / blocks_x * kBlock + block_y(in_block)) * inv_f;
                distance[pixel] = hit ? float(hits.t[offset] * std::sqrt(1 + x * x + y * y)) : none;
            }
        }
    });
}

} // namespace

void resize(ShadeMemory& memory, int tile_size, bool color, std::span<const Aov> aovs)
{
    const std::size_t samples = std::size_t(tile_size) * std::size_t(tile_size);
    memory.plane.resize(samples * 17);
    float* next = memory.plane.data();
    const auto point = [&](auto& planes, bool wanted) {
        for (float*& plane : planes) {
            plane = wanted ? next : nullptr;
            if (wanted) next += samples;
        }
    };
    ShadeTargets& targets = memory.targets;
    point(targets.color, color);
    point(targets.uv, contains(aovs, Aov::uv));
    point(targets.normal, contains(aovs, Aov::normal));
    point(targets.geometric_normal, contains(aovs, Aov::geometric_normal));
    point(targets.position, contains(aovs, Aov::position));
    point(targets.albedo, contains(aovs, Aov::albedo));
}

void resize(Film& film, int width, int height, bool color, std::span<const Aov> aovs)
{
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    const auto size = [&](Plane& plane, int channels) {
        plane.channels = channels;
        plane.value.resize(pixels * std::size_t(channels));
    };
    if (color) size(film.color, 3);
    for (const Aov aov : aovs) {
        if (aov == Aov::item)
            film.item.resize(pixels);
        else
            size(film[aov], aov_channels(aov));
    }
}

void clear_unused(Film& film, bool color, std::span<const Aov> aovs)
{
    if (!color) film.color.value.clear();
    if (!contains(aovs, Aov::item)) film.item.clear();
    for (int a = 0; a < kAovCount; ++a)
        if (!contains(aovs, Aov(a))) film[Aov(a)].value.clear();
}

void store_tile(const TilePlace& place, const HitTile& hits, const ShadeTargets& shaded, Film& film)
{
    const PixelRect rect = pixels_of(place);
    const auto copy = [&]<int kChannels>(float* const (&from)[kChannels], Plane& to) {
        if (!from[0]) return;
        const auto& planes = reinterpret_cast<const float* const(&)[kChannels]>(from);
        copy_plane<kChannels>(rect, film.width, hits.size, planes, to);
    };
    if (place.samples == 1)
        copy(shaded.color, film.color);
    else if (shaded.color[0])
        average_color(rect, place, {shaded.color[0], shaded.color[1], shaded.color[2]}, film);
    copy(shaded.uv, film[Aov::uv]);
    copy(shaded.normal, film[Aov::normal]);
    copy(shaded.geometric_normal, film[Aov::geometric_normal]);
    copy(shaded.position, film[Aov::position]);
    copy(shaded.albedo, film[Aov::albedo]);
    if (place.samples == 1) store_hits(rect, hits, film);
}

std::uint64_t count_hits(const HitTile& hits)
{
    std::uint64_t count = 0;
    for (const HitRun& run : hits.runs) count += std::uint64_t(std::popcount(run.samples));
    return count;
}

} // namespace firsthit
