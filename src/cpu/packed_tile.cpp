// packed_tile.cpp - packs the hits of an interleaved tile, so that shading works on full registers.
#include "cpu/packed_tile.h"

#include "cpu/film_planes.h"

#include <algorithm>
#include <bit>

namespace firsthit {
namespace {

/// From the samples of a run in block number i of N to those in the packed block.
std::uint64_t packed_samples(const Packing::Block& packing, std::size_t i, std::uint64_t samples)
{
    const std::uint64_t shot = packing.shot[i];
    std::uint64_t packed = 0;
    if (samples == shot) {
        packed = ~std::uint64_t(0) >> (64 - std::popcount(shot));
    } else {
        for (; samples; samples &= samples - 1) {
            const std::uint64_t before = (samples & -samples) - 1;
            packed |= std::uint64_t(1) << std::popcount(shot & before);
        }
    }
    return packed << packing.first[i];
}

/// The blocks of a row that are packed together.
struct PackedBlocks {
    std::size_t first;
    int count;
};

/// Packs which directions of the sky the samples of some blocks see, as block number `to`.
void pack_sky(const SkyVisibility& sky, const Packing::Block& packing, const PackedBlocks& blocks,
    std::vector<std::uint64_t>& words, std::uint32_t to)
{
    const std::size_t count = sky.rays->count();
    if (words.size() < (to + 1) * count) words.resize((to + 1) * count);
    for (std::size_t k = 0; k < count; ++k) {
        std::uint64_t packed = 0;
        for (int i = 0; i < blocks.count; ++i) {
            const auto block = std::size_t(i);
            const std::uint64_t seen = sky.of_block(blocks.first + block)[k] & packing.shot[block];
            if (seen != 0) packed |= packed_samples(packing, block, seen);
        }
        words[to * count + k] = packed;
    }
}

/// Adds the samples of a run to the run of the same item in [first, end), or appends the run if
/// there is none. Searches from the end, because neighbouring blocks mostly share their items.
void add_run(const HitRun& run, HitRun* first, HitRun*& end)
{
    for (HitRun* other = end; other-- > first;) {
        if (other->item != run.item) continue;
        other->samples |= run.samples;
        return;
    }
    *end++ = run;
}

} // namespace

Packing::Packing(int every) : every_(every), lattice_(every)
{
    for (int phase = 0; phase < every; ++phase) {
        Block& block = block_[std::size_t(phase)];
        std::size_t next = 0;
        for (int i = 0; i < every; ++i) {
            block.first[std::size_t(i)] = std::uint8_t(next);
            block.shot[std::size_t(i)] = lattice_.shot(phase + i * kBlock, 0);
            for (std::uint64_t rest = block.shot[std::size_t(i)]; rest; rest &= rest - 1, ++next) {
                const int k = std::countr_zero(rest);
                block.place.x[next] = float(i * kBlock + block_x(k));
                block.place.y[next] = float(block_y(k));
                block.source[next] = std::uint16_t(i * kBlockSamples + k);
            }
        }
        block.first[std::size_t(every)] = std::uint8_t(next);
    }
}

void resize(PackedTile& packed, int tile_size, std::size_t lights)
{
    const std::size_t samples = std::size_t(tile_size) * std::size_t(tile_size);
    packed.run.resize(samples);
    packed.place.resize(samples / kBlockSamples);
    packed.covered.resize(samples / kBlockSamples);
    for (Buffer<float>* plane : {&packed.t, &packed.u, &packed.v}) plane->resize(samples);
    packed.light_visibility.resize(lights * samples);
    packed.lights = lights;
}

void pack(const Packing& packing, const std::array<int, 2>& first_pixel, const HitTile& hits,
    const LightVisibility& lit, PackedTile& packed)
{
    const int blocks_x = hits.size / kBlock;
    const std::size_t samples = std::size_t(hits.size) * std::size_t(hits.size);
    HitRun* end = packed.run.data();
    std::uint32_t count = 0; // of packed blocks; those without an item are left out
    for (auto run = hits.runs.begin(); run != hits.runs.end();) {
        const int row = run->block / blocks_x, column = run->block % blocks_x;
        const int first = column / packing.every() * packing.every();
        const int last = std::min(first + packing.every(), blocks_x);
        const auto first_block = std::size_t(row * blocks_x + first);
        const Packing::Block& block =
            packing.at(first_pixel[0] + first * kBlock, first_pixel[1] + row * kBlock);

        HitRun* const begin = end;
        std::uint64_t covered = 0;
        for (; run != hits.runs.end() && run->block < row * blocks_x + last; ++run) {
            HitRun add = *run;
            add.block = std::uint16_t(count);
            add.samples = packed_samples(block, run->block - first_block, run->samples);
            covered |= add.samples;
            add_run(add, begin, end);
        }

        const std::size_t from = first_block * kBlockSamples, to = count * kBlockSamples;
        const auto copy = [&](const float* plane, float* packed_plane) {
            const int used = block.first[std::size_t(last - first)];
            for (int k = 0; k < used; ++k)
                packed_plane[to + std::size_t(k)] = plane[from + block.source[std::size_t(k)]];
        };
        copy(hits.t, packed.t.data());
        copy(hits.u, packed.u.data());
        copy(hits.v, packed.v.data());
        if (lit.sky.rays) pack_sky(lit.sky, block, {first_block, last - first}, packed.sky, count);
        if (lit.lit)
            for (std::size_t l = 0; l < packed.lights; ++l)
                copy(lit.of_light(l), packed.light_visibility.data() + l * samples);
        packed.place[count] = {float(first * kBlock), float(row * kBlock), &block.place};
        packed.covered[count] = covered;
        ++count;
    }
    packed.hits = hits;
    packed.hits.runs = packed.run.span().first(std::size_t(end - packed.run.data()));
    packed.hits.places = packed.place.span().first(count);
    packed.hits.packed = true;
    packed.hits.covered = packed.covered.data();
    packed.hits.item = nullptr;
    packed.hits.t = packed.t.data();
    packed.hits.u = packed.u.data();
    packed.hits.v = packed.v.data();
    packed.lit = {lit.lit ? packed.light_visibility.data() : nullptr, samples,
        {packed.sky.data(), lit.sky.rays}};
}

void store_packed(const PackedTile& packed, const TilePlace& place, const ShadeTargets& shaded,
    const glm::vec3& background, Film& film)
{
    const PixelRect rect = pixels_of(place);
    const auto width = std::size_t(film.width);
    float* const corner =
        &film.color.value[(std::size_t(rect.film_y) * width + std::size_t(rect.film_x)) * 3];
    for (int y = 0; y < rect.height; ++y) {
        float* pixel = corner + std::size_t(y) * width * 3;
        for (int x = 0; x < rect.width; ++x, pixel += 3)
            for (int c = 0; c < 3; ++c) pixel[c] = background[c];
    }
    for (std::size_t block = 0; block < packed.hits.places.size(); ++block) {
        const BlockPlace& where = packed.hits.places[block];
        for (std::uint64_t rest = packed.covered[block]; rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const int x = int(where.x + where.samples->x[k]);
            const int y = int(where.y + where.samples->y[k]);
            if (x >= rect.width || y >= rect.height) continue; // outside the picture
            float* pixel = corner + (std::size_t(y) * width + std::size_t(x)) * 3;
            const std::size_t at = block * kBlockSamples + std::size_t(k);
            for (int c = 0; c < 3; ++c) pixel[c] = shaded.color[c][at];
        }
    }
}

} // namespace firsthit
