// packed_tile.h - the hits of an interleaved tile, side by side, so that shading has full registers.
#pragma once

#include "base/buffer.h"
#include "hits/lattice.h"
#include "hits/hit_tile.h"
#include "hits/light_visibility.h"

#include <firsthit/film.h>

#include <array>
#include <cstdint>

namespace firsthit {

struct ShadeTargets;
struct TilePlace;

/// The lattice's samples of N blocks that lie side by side, which are 64, become one packed block.
class Packing {
  public:
    /// Of one place of the lattice.
    struct Block {
        BlockSamplesXY place;                   // of each packed sample, from the first block's
        std::array<std::uint16_t, 64> source{}; // 64 * block + sample
        std::array<std::uint64_t, 16> shot{};   // of each block
        std::array<std::uint8_t, 17> first{};   // packed sample of each block
    };

    /// every  1 to Lattice::kMost
    explicit Packing(int every);

    int every() const { return every_; }
    const Lattice& lattice() const { return lattice_; }

    /// Where the first block's first sample is pixel (x, y) of the picture.
    const Block& at(int x, int y) const { return block_[std::size_t(lattice_.phase(x, y))]; }

  private:
    int every_;
    Lattice lattice_;
    std::array<Block, Lattice::kMost> block_{}; // by phase
};

/// A packed tile; kept from frame to frame.
struct PackedTile {
    HitTile hits;
    LightVisibility lit;
    Buffer<HitRun> run;
    Buffer<BlockPlace> place;         // (blocks)
    Buffer<std::uint64_t> covered;    // (blocks) samples with an item
    Buffer<float> t, u, v, lit_share; // (samples), lit (lights, samples)
    std::size_t lights = 0;
};

/// Prepares a worker's memory for tiles of that size.
void resize(PackedTile& packed, int tile_size, std::size_t lights);

/// Packs a tile whose items are all on the lattice.
/// first_pixel  the picture's pixel that the tile's first sample is: x, y
void pack(const Packing& packing, const std::array<int, 2>& first_pixel, const HitTile& hits,
    const LightVisibility& lit, PackedTile& packed);

/// Writes the packed tile's colours to the film, and the background to all its other pixels.
void store_packed(const PackedTile& packed, const TilePlace& place, const ShadeTargets& shaded,
    const glm::vec3& background, Film& film);

} // namespace firsthit
