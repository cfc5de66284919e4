// film_planes.cpp - stores tiles of samples in the planes of the film.
#include "cpu/film_planes.h"

#include "cpu/adaptive/pixel_marks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

namespace firsthit {
namespace {

bool contains(std::span<const Aov> aovs, Aov wanted)
{
    return std::find(aovs.begin(), aovs.end(), wanted) != aovs.end();
}

/// Calls f(pixel in the film, offset in the tile, count) for each four pixels of a row, or fewer at
/// the end of the row. Each pixel is one sample. `count` is a constant 4 except in the last call of
/// a row.
template <class F>
void for_quads(const PixelRect& rect, int film_width, int tile_size, const F& f)
{
    for (int y = 0; y < rect.height; ++y) {
        std::size_t pixel =
            std::size_t(rect.film_y + y) * std::size_t(film_width) + std::size_t(rect.film_x);
        int x = 0;
        for (; x + 4 <= rect.width; x += 4, pixel += 4)
            f(pixel, tile_offset(x, y, tile_size), std::integral_constant<int, 4>());
        if (x < rect.width) f(pixel, tile_offset(x, y, tile_size), rect.width - x);
    }
}

/// Larger planes do not fit into a core's share of the caches, and are written past them.
constexpr std::size_t kCachedBytes = std::size_t(4) << 20;

/// Copies channels of the tile to a plane of the film.
void copy_plane(const PixelRect& rect, const Film& film, int tile_size,
    std::span<const float* const> from, float* to)
{
    const std::size_t bytes =
        std::size_t(film.width) * std::size_t(film.height) * from.size() * sizeof(float);
    copy_rows(rect, tile_size, from, {to, film.width, bytes > kCachedBytes});
}

/// offset  of the sample in the tile
bool is_hole(const TilePlace& place, int offset)
{
    return place.holes[std::size_t(offset) / kBlockSamples] >> offset % kBlockSamples & 1;
}

bool has_holes(const TilePlace& place)
{
    return std::any_of(place.holes.begin(), place.holes.end(), [](std::uint64_t w) { return w; });
}

/// Calls f(offset in the tile) for the samples of pixel (x, y) of the tile.
template <class F>
void for_samples(const TilePlace& place, int x, int y, const F& f)
{
    const int n = place.samples;
    for (int sy = 0; sy < n; ++sy)
        for (int sx = 0; sx < n; ++sx)
            f(tile_offset(x * n + sx, y * n + sy, place.layout.tile_size));
}

/// Stores the mean colour of the samples that are no holes, for pixels with samples of both kinds.
void average_without_holes(const PixelRect& rect, const TilePlace& place,
    const std::array<const float*, 3>& from, Film& film)
{
    for (int y = 0; y < rect.height; ++y) {
        for (int x = 0; x < rect.width; ++x) {
            float sum[3] = {};
            int count = 0;
            for_samples(place, x, y, [&](int offset) {
                if (is_hole(place, offset)) return;
                for (std::size_t c = 0; c < 3; ++c) sum[c] += from[c][offset];
                ++count;
            });
            if (count == 0 || count == place.samples * place.samples) continue;
            const std::size_t pixel = std::size_t(rect.film_y + y) * std::size_t(film.width) +
                                      std::size_t(rect.film_x + x);
            for (std::size_t c = 0; c < 3; ++c)
                film.color.value[pixel * 3 + c] = sum[c] / float(count);
        }
    }
}

/// Stores the mean colour of each pixel's samples.
void average_color(const PixelRect& rect, const TilePlace& place,
    const std::array<const float*, 3>& from, Film& film)
{
    const int n = place.samples;
    const float share = 1.0f / float(n * n);
    const int x0 = rect.film_x + place.region.x, y0 = rect.film_y + place.region.y;
    for (int y = 0; y < rect.height; ++y) {
        for (int x = 0; x < rect.width; ++x) {
            if (place.only && !place.only->has(x0 + x, y0 + y)) continue;
            float sum[3] = {};
            for (int sy = 0; sy < n; ++sy) {
                for (int sx = 0; sx < n; ++sx) {
                    const int offset = tile_offset(x * n + sx, y * n + sy, place.layout.tile_size);
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += from[c][offset];
                }
            }
            const std::size_t pixel = std::size_t(rect.film_y + y) * std::size_t(film.width) +
                                      std::size_t(rect.film_x + x);
            for (std::size_t c = 0; c < 3; ++c) film.color.value[pixel * 3 + c] = sum[c] * share;
        }
    }
}

/// Stores the distances from where the rays start, computed from depths along the axis.
///
/// shear  Pencil::shear
void store_distance(
    const PixelRect& rect, const HitTile& hits, const glm::dvec3& shear, int film_width, float* to)
{
    const Rays& rays = hits.rays;
    const double step_x = rays.step_x, step_y = rays.step_y;
    const int blocks_x = hits.size / kBlock;
    for_quads(rect, film_width, hits.size, [&](std::size_t pixel, int offset, int count) {
        for (int k = 0; k < count; ++k, ++pixel, ++offset) {
            const int in_block = offset % kBlockSamples, block = offset / kBlockSamples;
            const int x = block % blocks_x * kBlock + block_x(in_block);
            const int y = block / blocks_x * kBlock + block_y(in_block);
            const double along_y = (double(rays.y0) + y) * step_y;
            const double dx = (double(rays.x0) + x) * step_x + (along_y * shear.x + shear.y);
            const double dy = along_y + shear.z;
            to[pixel] = float(hits.t[offset] * std::sqrt(1 + dx * dx + dy * dy));
        }
    });
}

/// Stores the share of each light that reaches the samples; 0 for samples without an item.
void store_lit(const PixelRect& rect, const HitTile& hits, const LightVisibility& lit,
    int film_width, Plane& to)
{
    const std::size_t lights = std::size_t(to.channels);
    for (std::size_t light = 0; light < lights; ++light) {
        const float* share = lit.of_light(light);
        for_quads(rect, film_width, hits.size, [&](std::size_t pixel, int offset, int count) {
            for (int k = 0; k < count; ++k, ++pixel, ++offset) {
                const bool hit = hits.item[offset] != kNoItem;
                to.value[pixel * lights + light] = !hit ? 0.0f : share ? share[offset] : 1.0f;
            }
        });
    }
}

/// Stores the planes that are parts of the hits.
void store_hits(const PixelRect& rect, const HitTile& hits, const Pencil& pencil, Film& film)
{
    if (!film.item.empty()) {
        static_assert(sizeof(std::uint32_t) == sizeof(float));
        const float* const item[] = {reinterpret_cast<const float*>(hits.item)};
        copy_plane(rect, film, hits.size, item, reinterpret_cast<float*>(film.item.data()));
    }
    if (!film[Aov::depth].empty()) {
        const float* const t[] = {hits.t};
        copy_plane(rect, film, hits.size, t, film[Aov::depth].value.data());
    }
    if (!film[Aov::barycentric].empty()) {
        const float* const weight[] = {hits.u, hits.v};
        copy_plane(rect, film, hits.size, weight, film[Aov::barycentric].value.data());
    }
    if (!film[Aov::distance].empty() && pencil.parallel) {
        const float* const t[] = {hits.t};
        copy_plane(rect, film, hits.size, t, film[Aov::distance].value.data());
    } else if (!film[Aov::distance].empty())
        store_distance(rect, hits, pencil.shear, film.width, film[Aov::distance].value.data());
}

} // namespace

PixelRect pixels_of(const TilePlace& place)
{
    const int side = place.layout.tile_size / place.samples; // in pixels
    const int x = place.layout.first_x(place.tile) / place.samples,
              y = place.layout.first_y(place.tile) / place.samples;
    return {place.part.x - place.region.x + x, place.part.y - place.region.y + y,
        std::min(side, place.part.width - x), std::min(side, place.part.height - y)};
}

/// Of all targets: floats of a sample.
constexpr std::size_t kShadedPlanes = 22;

void resize(ShadeMemory& memory, int tile_size, bool color, std::span<const Aov> aovs)
{
    const std::size_t samples = std::size_t(tile_size) * std::size_t(tile_size);
    memory.plane.resize(samples * kShadedPlanes);
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
    point(targets.metallic_roughness, contains(aovs, Aov::metallic_roughness));
    point(targets.emission, contains(aovs, Aov::emission));
}

void store_tile(const TilePlace& place, const HitTile& hits, const LightVisibility& lit,
    const ShadeTargets& shaded, Film& film)
{
    const PixelRect rect = pixels_of(place);
    const auto copy_shaded = [&]<std::size_t kChannels>(float* const(&from)[kChannels], Plane& to) {
        if (!from[0]) return;
        std::array<const float*, kChannels> planes;
        std::copy_n(from, kChannels, planes.begin());
        copy_plane(rect, film, hits.size, planes, to.value.data());
    };
    if (place.samples == 1) {
        copy_shaded(shaded.color, film.color);
        store_hits(rect, hits, place.layout.pencil, film);
        if (!film[Aov::lit].empty()) store_lit(rect, hits, lit, film.width, film[Aov::lit]);
    } else if (shaded.color[0]) {
        const std::array<const float*, 3> color{shaded.color[0], shaded.color[1], shaded.color[2]};
        average_color(rect, place, color, film);
        if (has_holes(place)) average_without_holes(rect, place, color, film);
    }
    copy_shaded(shaded.uv, film[Aov::uv]);
    copy_shaded(shaded.normal, film[Aov::normal]);
    copy_shaded(shaded.geometric_normal, film[Aov::geometric_normal]);
    copy_shaded(shaded.position, film[Aov::position]);
    copy_shaded(shaded.albedo, film[Aov::albedo]);
    copy_shaded(shaded.metallic_roughness, film[Aov::metallic_roughness]);
    copy_shaded(shaded.emission, film[Aov::emission]);
}

void store_background(const TilePlace& place, const glm::vec3& background, Film& film)
{
    const std::size_t bytes = film.color.value.size() * sizeof(float);
    fill_rows(
        pixels_of(place), background, {film.color.value.data(), film.width, bytes > kCachedBytes});
}

void mark_holes(const TilePlace& place, int film_width, std::span<std::uint8_t> mask)
{
    const PixelRect rect = pixels_of(place);
    const bool any = has_holes(place);
    if (any && place.samples == 1) {
        for_quads(rect, film_width, place.layout.tile_size,
            [&](std::size_t pixel, int offset, auto count) {
                const std::uint64_t bits =
                    place.holes[std::size_t(offset) / kBlockSamples] >> offset % kBlockSamples;
                for (int k = 0; k < count; ++k) mask[pixel + std::size_t(k)] = bits >> k & 1;
            });
        return;
    }
    for (int y = 0; y < rect.height; ++y) {
        std::uint8_t* row = mask.data() + std::size_t(rect.film_y + y) * std::size_t(film_width) +
                            std::size_t(rect.film_x);
        std::fill_n(row, rect.width, std::uint8_t(any));
        for (int x = 0; any && x < rect.width; ++x)
            for_samples(place, x, y, [&](int offset) { row[x] &= is_hole(place, offset); });
    }
}

std::uint64_t count_hits(const HitTile& hits)
{
    std::uint64_t count = 0;
    if (hits.covered) {
        for (std::size_t block = 0; block < hits.blocks(); ++block) {
            // Mostly all samples are covered, or none. These cases need no popcount, which is a
            // function call where the compiler may not use the instruction.
            const std::uint64_t covered = hits.covered[block];
            if (covered == ~std::uint64_t(0))
                count += kBlockSamples;
            else if (covered != 0)
                count += std::uint64_t(std::popcount(covered));
        }
        return count;
    }
    for (const HitRun& run : hits.runs) count += std::uint64_t(std::popcount(run.samples));
    return count;
}

} // namespace firsthit
