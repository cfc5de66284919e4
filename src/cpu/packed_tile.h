// packed_tile.h - packs the hits of an interleaved tile, so that shading works on full registers.
#pragma once

#include "base/buffer.h"
#include "hits/lattice.h"
#include "hits/hit_tile.h"
#include "hits/light_visibility.h"

#include <firsthit/film.h>

#include <array>
#include <cstdint>
#include <vector>

namespace firsthit {

struct ShadeTargets;
struct TilePlace;

/// How samples are packed: N neighbouring blocks of a row have 64 samples on the lattice together,
/// and these become one packed block.
class Packing {
  public:
    /// The packing of N blocks at one phase of the lattice.
    struct Block {
        BlockSamplesXY place;                   // offset of each packed sample from the first block
        std::array<std::uint16_t, 64> source{}; // 64 * block + sample, of each packed sample
        std::array<std::uint64_t, 16> shot{};   // bits of the samples on the lattice, of each block
        std::array<std::uint8_t, 17>
            first{}; // the first packed sample of each block, and their number
    };

    /// every  N, from 1 to Lattice::kMost
    explicit Packing(int every);

    int every() const { return every_; }
    const Lattice& lattice() const { return lattice_; }

    /// The packing of N blocks whose first sample is pixel (x, y) of the picture.
    const Block& at(int x, int y) const { return block_[std::size_t(lattice_.phase(x, y))]; }

  private:
    int every_;
    Lattice lattice_;
    std::array<Block, Lattice::kMost> block_{}; // by phase
};

/// A packed tile and its memory, which is kept from frame to frame.
struct PackedTile {
    HitTile hits;
    LightVisibility lit;
    Buffer<HitRun> run;
    Buffer<BlockPlace> place;       // (blocks)
    Buffer<std::uint64_t> covered;  // (blocks) a bit for each sample with an item
    Buffer<float> t, u, v;          // (samples)
    Buffer<float> light_visibility; // (lights, samples)
    std::vector<std::uint64_t> sky; // (blocks, directions) if there is a sky
    std::size_t lights = 0;
};

/// Prepares a packed tile for tiles of tile_size x tile_size samples. Allocates only to grow.
void resize(PackedTile& packed, int tile_size, std::size_t lights);

/// Packs the hits of a tile whose items are all on the lattice.
///
/// first_pixel  x and y of the picture's pixel that is the tile's first sample
/// lit          of the tile's samples
/// packed       resized to the tile's size; packed.hits and packed.lit point into it
void pack(const Packing& packing, const std::array<int, 2>& first_pixel, const HitTile& hits,
    const LightVisibility& lit, PackedTile& packed);

/// Stores the colours of the packed tile in the film, and the background in its other pixels.
///
/// shaded  the colours of the packed samples
void store_packed(const PackedTile& packed, const TilePlace& place, const ShadeTargets& shaded,
    const glm::vec3& background, Film& film);

} // namespace firsthit
