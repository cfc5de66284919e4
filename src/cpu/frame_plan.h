// frame_plan.h - which stages a frame of the cpu engine runs, and what is kept between them.
#pragma once

#include "cpu/packed_tile.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace firsthit {

/// One pass over the picture: which rays are shot, and what is kept of them.
struct PassPlan {
    int samples = 1;           // on a pixel's side
    int tile_size = 64;        // samples on a side: whole blocks and whole pixels
    int part_side = 0;         // pixels on the side of a part, at most: whole tiles
    bool color = true;         // is shaded; else only planes are made
    std::span<const Aov> aovs; // planes
    bool shadows = false; // are found: all tiles' hits are kept for the lights; else each tile is
                          // finished while it is in cache
    bool keeps_items = false;         // of the hits, see HitMemory::items
    bool keeps_misses = false;        // and HitMemory::misses
    const Packing* packing = nullptr; // of the pixels whose rays are shot; null: all
    bool fill = false;                // holes get the colours around them

    /// Samples of a region, once for each loop over its tiles.
    std::uint64_t work(const Region& region) const
    {
        return samples_of(region) * (shadows ? 3 : 1);
    }
    std::uint64_t samples_of(const Region& region) const
    {
        return std::uint64_t(region.width) * std::uint64_t(region.height) *
               std::uint64_t(samples * samples);
    }
};

/// All passes of a frame. Points into the settings and into itself.
class FramePlan {
  public:
    /// lights       of the world
    /// exact_items  the item source misses nothing
    FramePlan(const Settings& settings, std::size_t lights, bool exact_items);
    FramePlan(const FramePlan&) = delete;
    FramePlan& operator=(const FramePlan&) = delete;

    std::span<const PassPlan> passes() const { return {pass_, count_}; }
    const ShadowOptions& shadows() const { return shadows_; }
    std::uint64_t work(const Region& region) const;

  private:
    void add(PassPlan pass, int tile_size);

    const ShadowOptions& shadows_;
    std::optional<Packing> packing_;
    PassPlan pass_[2];
    std::size_t count_ = 0;
};

} // namespace firsthit
