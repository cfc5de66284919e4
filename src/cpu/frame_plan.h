// frame_plan.h - plans which stages a frame of the cpu engine runs, and what is kept between them.
#pragma once

#include "base/pixel_steps.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

class EdgeFinder;
struct FrameSources;
struct PixelMarks;

/// A pass over the picture: which rays are shot, and what is kept of their hits.
struct PassPlan {
    int samples = 1;             // samples on a side of a pixel
    int tile_size = 64;          // samples on a side of a tile: whole blocks and whole pixels
    int part_side = 0;           // the most pixels on a side of a part: whole tiles
    bool color = true;           // whether colours are shaded; otherwise only planes are made
    std::span<const Aov> aovs;   // the planes that are made
    bool shadows = false;        // whether shadows are found
    bool sky = false;            // whether it is found which directions of the sky the hits see
    bool keeps_items = false;    // HitMemory::items
    bool keeps_misses = false;   // HitMemory::misses
    PixelSteps steps = {};       // between the pixels whose rays are shot
    bool fill = false;           // whether holes get the colours around them
    EdgeFinder* edges = nullptr; // FrameSources::edges, in the pass that makes colours
    const PixelMarks* only = nullptr; // FrameSources::only

    /// Whether the hits of all tiles are kept, for the lights or for the sky. Otherwise each tile is
    /// finished while it is in cache.
    bool keeps_hits() const { return shadows || sky; }

    /// The work of a region of shot pixels in this pass: its samples, once for each loop over its tiles, and
    /// once for each of the stages between.
    std::uint64_t work(const Region& region) const
    {
        return samples_of(region) * (1 + keeps_hits() + shadows + sky);
    }
    /// The number of samples in a region, which is in pixels.
    std::uint64_t samples_of(const Region& region) const
    {
        return std::uint64_t(region.width) * std::uint64_t(region.height) *
               std::uint64_t(samples * samples);
    }
};

/// All passes of a frame. It points into the settings and into itself.
class FramePlan {
  public:
    /// settings     outlive the plan
    /// lights       number of lights in the world
    /// exact_items  whether the item source never has holes
    /// sources      for what is looked for, and in which pixels
    FramePlan(const Settings& settings, std::size_t lights, bool exact_items,
        const FrameSources& sources);
    FramePlan(const FramePlan&) = delete;
    FramePlan& operator=(const FramePlan&) = delete;

    std::span<const PassPlan> passes() const { return {pass_, count_}; }
    const ShadowOptions& shadows() const { return shadows_; }
    const Sky& sky() const { return sky_; }
    /// The work of all passes, for FrameProgress.
    std::uint64_t work(const Region& region) const;

  private:
    void add(PassPlan pass, int tile_size);

    const ShadowOptions& shadows_;
    const Sky& sky_;
    PassPlan pass_[2];
    std::size_t count_ = 0;
};

} // namespace firsthit
